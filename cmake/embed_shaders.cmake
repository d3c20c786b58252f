# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D FILES="a;b" -D OUT=file.cpp -P embed_shaders.cmake: text files as one C++ table, see render/shader_text.hpp.
set(table "")
foreach(file ${FILES})
  file(READ ${file} text)
  get_filename_component(name ${file} NAME)
  string(APPEND table "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUT} "// Made by cmake/embed_shaders.cmake.
#include \"render/shader_text.hpp\"

#include <utility>

#include \"base/assert.hpp\"

namespace rhexis {

namespace {

constexpr std::pair<std::string_view, std::string_view> table[] = {
${table}};

}  // namespace

std::string_view shader_text(std::string_view file) {
    for (const auto& [name, text] : table) {
        if (name == file) {
            return text;
        }
    }
    RHEXIS_ASSERT(false);
    return {};
}

}  // namespace rhexis
")
