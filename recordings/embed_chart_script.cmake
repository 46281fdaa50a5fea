# Writes the bytes of INPUT as a C++ array: railpem::recordings::chart_script().
file(READ ${INPUT} hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include <string_view>
namespace railpem::recordings {
std::string_view chart_script();
static const unsigned char bytes[] = {
${bytes}};
std::string_view chart_script() { return {reinterpret_cast<const char*>(bytes), sizeof(bytes)}; }
}
")
