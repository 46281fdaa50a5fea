#pragma once
// Where a result comes from, as it stands in every file that is written.

#include <string>
#include <vector>

namespace railpem::app {

/// An input as it was read.
struct InputFile {
    std::string path;    ///< as the user named it
    std::string sha256;  ///< empty where it cannot be read twice (a pipe)
};

struct Provenance {
    std::string program;            ///< "railpem 0.1.0 (commit 1a2b3c4)"
    std::string command;            ///< quoted for a shell; empty from Python
    std::vector<std::string> set;   ///< options --set as they were given
    std::vector<InputFile> inputs;  ///< every file that was read
};

/// What the command line was: called once, where the program begins.
void remember_command(int argc, const char* const* argv);

/// Of this run: command, every file that has been read so far, and the options --set among the arguments. Hashes are
/// taken now.
Provenance run_provenance();

/// Of a call from Python: the program, and the files it names.
Provenance call_provenance(const std::vector<std::string>& paths, const std::vector<std::string>& set);

/// The program and nothing else: for recordings, which shall not tell what is hidden in them.
Provenance program_provenance();

/// One word or text as a POSIX shell reads it back: 'run 1', it'\''s.
std::string shell_quoted(const std::string& text);

/// One line: "written by railpem 0.1.0 (commit …); command: …; set: …; input: … sha256 …".
std::string provenance_line(const Provenance& provenance);

/// A text with its provenance, in the way of its kind, which the ending of `name` tells. `.csv`: a comment line at the
/// end, where readers that take the first line for the header leave it alone; `.toml`: a comment at the beginning;
/// `.html`: a comment at the beginning; `.json` (an object): its last key, "provenance". Others stay as they are.
std::string stamped(const std::string& name, std::string text, const Provenance& provenance);

}  // namespace railpem::app
