# Writes the bytes of INPUT as a C++ array: railpem::FOLDER::NAME(), declared in FOLDER/page/page_parts.hpp. Called by railpem_embed().
file(READ ${INPUT} hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"${FOLDER}/page/page_parts.hpp\"
namespace railpem::${FOLDER} {
std::string_view ${NAME}() {
static const unsigned char bytes[] = {
${bytes}};
return {reinterpret_cast<const char*>(bytes), sizeof(bytes)};
}
}
")
