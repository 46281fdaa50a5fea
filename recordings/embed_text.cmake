# Writes the bytes of INPUT as a C++ array: railpem::recordings::NAME().
file(READ ${INPUT} hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"recordings/page/page_parts.hpp\"
namespace railpem::recordings {
static const unsigned char bytes[] = {
${bytes}};
std::string_view ${NAME}() { return {reinterpret_cast<const char*>(bytes), sizeof(bytes)}; }
}
")
