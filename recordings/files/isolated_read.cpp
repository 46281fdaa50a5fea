#include "recordings/files/isolated_read.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>

#include "recordings/files/read_error.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RAILPEM_ADDRESS_SANITIZER 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define RAILPEM_ADDRESS_SANITIZER 1
#endif

namespace railpem::recordings {
namespace {

enum class Answer : char { table = 't', refused = 'r', end = 'e' };

void write_all(int pipe, const void* data, std::size_t bytes) {
    const char* at = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t written = write(pipe, at, bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) _exit(3);  // the parent is gone: nobody is left to tell
        at += written;
        bytes -= static_cast<std::size_t>(written);
    }
}

void write_text(int pipe, const std::string& text) {
    const std::size_t size = text.size();
    write_all(pipe, &size, sizeof size);
    write_all(pipe, text.data(), size);
}

template <class Plain>
void write_plain(int pipe, const Plain& value) {
    write_all(pipe, &value, sizeof value);
}

void write_statements(int pipe, const FileStatements& says) {
    write_text(pipe, says.sampling_rate_where);
    write_text(pipe, says.start);
    write_plain(pipe, says.promised_rows);
    write_plain(pipe, says.held_rows);
    write_plain(pipe, says.columns.size());
    for (const ColumnStatement& column : says.columns) {
        write_text(pipe, column.unit);
        write_text(pipe, column.unit_where);
        write_text(pipe, column.scale_where);
        write_plain(pipe, column.share_of_full_scale ? '1' : '0');
        for (const auto& number : {column.scale, column.offset, column.sampling_rate_hz, column.start_s}) {
            write_plain(pipe, number.has_value() ? '1' : '0');
            write_plain(pipe, number.value_or(0.0));
        }
    }
}

void write_table(int pipe, const DataTable& table) {
    const std::array<std::size_t, 3> sizes = {table.names.size(), table.rows(), table.notes.size()};
    write_all(pipe, sizes.data(), sizeof sizes);
    write_all(pipe, &table.sampling_rate_hz, sizeof table.sampling_rate_hz);
    for (const std::string& name : table.names) write_text(pipe, name);
    for (const std::string& note : table.notes) write_text(pipe, note);
    write_statements(pipe, table.says);
    for (const auto& column : table.columns) write_all(pipe, column.data(), column.size() * sizeof(double));
}

#ifndef RAILPEM_ADDRESS_SANITIZER
/// What a reader of this file may need: its numbers, when it is compressed as far as deflate goes (1032:1, zlib.net)
/// and every byte becomes a double, beside what the process has mapped already. A small file that asks for gigabytes is
/// refused before it gets them.
std::size_t address_space(const std::string& file, const ReadLimits& limits) {
    constexpr std::size_t libraries = std::size_t{256} << 20, expansion = 1032 * (sizeof(double) + 2);
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    const std::size_t most = limits.memory_bytes + (std::size_t{1} << 30);
    const std::size_t needed = ignored || size > most / expansion ? most : static_cast<std::size_t>(size) * expansion;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + libraries + needed;
}
#endif

void send_answer(int pipe, Answer answer) {
    write_all(pipe, &answer, 1);
}

void send_table(int pipe, const DataTable& table) {
    for (std::size_t i = 1; i < table.columns.size(); ++i)
        if (table.columns[i].size() != table.rows())
            throw ReadError("", 0,
                            fmt::format("'{}' has {} samples and '{}' has {}", table.names[0], table.rows(),
                                        table.names[i], table.columns[i].size()),
                            "channels of one length");
    send_answer(pipe, Answer::table);
    write_table(pipe, table);
}

void send_refusal(int pipe, const std::string& problem, const std::string& allowed) {
    send_answer(pipe, Answer::refused);
    write_text(pipe, problem);
    write_text(pipe, allowed);
}

[[noreturn]] void be_the_child(int pipe, [[maybe_unused]] const std::string& file, const ReadLimits& limits,
                               const std::function<void(const SendTable&)>& work) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const rlimit processor{static_cast<rlim_t>(limits.seconds) + 1, static_cast<rlim_t>(limits.seconds) + 2};
    setrlimit(RLIMIT_CPU, &processor);
#ifndef RAILPEM_ADDRESS_SANITIZER  // which maps terabytes of shadow memory
    const std::size_t most = address_space(file, limits);
    const rlimit memory{most, most};
    setrlimit(RLIMIT_AS, &memory);
#endif
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(signal, SIG_DFL);
    std::set_terminate([] { _exit(2); });  // what the parent would do then, its folders among it, is not for the child
    const int silent = open("/dev/null", O_WRONLY);
    if (silent >= 0) {  // what the libraries print about a damaged file is not for the user
        dup2(silent, STDOUT_FILENO);
        dup2(silent, STDERR_FILENO);
    }
    try {
        work([pipe](const DataTable& table) { send_table(pipe, table); });
        send_answer(pipe, Answer::end);
    } catch (const ReadError& error) {
        send_refusal(pipe, error.problem(), error.allowed());
    } catch (const std::bad_alloc&) {
        send_refusal(pipe, "reading it would take too much memory",
                     fmt::format("at most {} MB of numbers", limits.memory_bytes >> 20));
    } catch (...) {
        _exit(2);
    }
    _exit(0);
}

/// The parent's end of the pipe: reads what was promised, or says that it did not come.
class Answers {
  public:
    Answers(int pipe, double seconds) : pipe_(pipe), seconds_(seconds) { wait_anew(); }
    ~Answers() { close(pipe_); }
    Answers(const Answers&) = delete;
    Answers& operator=(const Answers&) = delete;

    /// What was spent on the last table is not the child's.
    void wait_anew() {
        until_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(static_cast<long>(1000.0 * seconds_));
    }

    bool read_all(void* data, std::size_t bytes) {
        char* at = static_cast<char*>(data);
        while (bytes > 0) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(until_ - std::chrono::steady_clock::now())
                    .count();
            pollfd ready{pipe_, POLLIN, 0};
            const int polled = left > 0 ? poll(&ready, 1, static_cast<int>(std::min<long>(left, 1000000))) : 0;
            if (polled < 0 && errno == EINTR) continue;
            if (polled <= 0) return false;
            const ssize_t got = read(pipe_, at, bytes);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            at += got;
            bytes -= static_cast<std::size_t>(got);
        }
        return true;
    }

    bool read_text(std::string& text) {
        std::size_t size = 0;
        if (!read_all(&size, sizeof size) || size > (std::size_t{1} << 24)) return false;
        text.resize(size);
        return read_all(text.data(), size);
    }

    bool read_table(DataTable& table, const ReadLimits& limits) {
        std::array<std::size_t, 3> sizes{};
        if (!read_all(sizes.data(), sizeof sizes) || !read_all(&table.sampling_rate_hz, sizeof table.sampling_rate_hz))
            return false;
        const auto [columns, rows, notes] = sizes;
        if (columns > limits.columns || notes > 1000 ||
            rows > limits.memory_bytes / sizeof(double) / std::max<std::size_t>(1, columns))
            return false;
        table.names.resize(columns);
        table.notes.resize(notes);
        for (std::string& name : table.names)
            if (!read_text(name)) return false;
        for (std::string& note : table.notes)
            if (!read_text(note)) return false;
        if (!read_statements(table.says, columns)) return false;
        for (std::size_t i = 0; i < columns; ++i) {
            table.columns.emplace_back(rows);
            if (!read_all(table.columns.back().data(), rows * sizeof(double))) return false;
        }
        return true;
    }

  private:
    template <class Plain>
    bool read_plain(Plain& value) {
        return read_all(&value, sizeof value);
    }

    bool read_number(std::optional<double>& number) {
        char has = '0';
        double value = 0.0;
        if (!read_plain(has) || !read_plain(value)) return false;
        if (has == '1') number = value;
        return true;
    }

    bool read_statements(FileStatements& says, std::size_t columns) {
        std::size_t count = 0;
        if (!read_text(says.sampling_rate_where) || !read_text(says.start) || !read_plain(says.promised_rows) ||
            !read_plain(says.held_rows) || !read_plain(count) || count > columns)
            return false;
        says.columns.resize(count);
        for (ColumnStatement& column : says.columns) {
            char share = '0';
            if (!read_text(column.unit) || !read_text(column.unit_where) || !read_text(column.scale_where) ||
                !read_plain(share) || !read_number(column.scale) || !read_number(column.offset) ||
                !read_number(column.sampling_rate_hz) || !read_number(column.start_s))
                return false;
            column.share_of_full_scale = share == '1';
        }
        return true;
    }

    int pipe_;
    double seconds_;
    std::chrono::steady_clock::time_point until_;
};

/// The child, until it is known to have ended by itself.
class Child {
  public:
    explicit Child(pid_t id) : id_(id) {}
    ~Child() {
        if (id_ <= 0) return;
        kill(id_, SIGKILL);
        wait();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    void ended() {
        wait();
        id_ = 0;
    }

  private:
    void wait() const {
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
    }
    pid_t id_;
};

/// Takes tables until the child says that there is no other. False when it stopped before.
bool take_tables(Answers& answers, const std::string& file, const ReadLimits& limits, Child& child,
                 const std::function<void(DataTable&)>& take) {
    for (;;) {
        answers.wait_anew();
        Answer answer = Answer::refused;
        if (!answers.read_all(&answer, 1)) return false;
        if (answer == Answer::end) return true;
        if (answer == Answer::table) {
            DataTable table;
            if (!answers.read_table(table, limits)) return false;
            take(table);
            continue;
        }
        std::string problem, allowed;
        if (!answers.read_text(problem) || !answers.read_text(allowed)) return false;
        child.ended();
        throw ReadError(file, 0, problem, allowed);
    }
}

}  // namespace

void read_isolated_blocks(const std::string& file, const ReadLimits& limits,
                          const std::function<void(const SendTable&)>& work,
                          const std::function<void(DataTable&)>& take) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw ReadError(file, 0, fmt::format("no pipe to its reader ({})", std::strerror(errno)),
                        "a system with a free file descriptor");
    const pid_t id = fork();
    if (id == 0) {
        close(ends[0]);
        be_the_child(ends[1], file, limits, work);
    }
    close(ends[1]);
    Answers answers(ends[0], limits.seconds);
    if (id < 0)
        throw ReadError(file, 0, fmt::format("no process for its reader ({})", std::strerror(errno)),
                        "a system that lets a process start");
    Child child(id);
    if (!take_tables(answers, file, limits, child, take))
        throw ReadError(file, 0, "the file is damaged: its reader stopped in the middle",
                        "a complete file of its kind");
    child.ended();
}

DataTable read_isolated(const std::string& file, const ReadLimits& limits, const std::function<DataTable()>& work) {
    DataTable whole;
    read_isolated_blocks(
        file, limits, [&](const SendTable& send) { send(work()); },
        [&](DataTable& table) { whole = std::move(table); });
    return whole;
}

}  // namespace railpem::recordings
