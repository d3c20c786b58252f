# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D FILES="a;b" -D HEADER=render/name.hpp -D FUNCTION=name -D OUT=file.cpp -P embed_texts.cmake: text files as one
# C++ table, and the function that the header declares.
set(table "")
foreach(file ${FILES})
  file(READ ${file} text)
  get_filename_component(name ${file} NAME)
  string(APPEND table "    {\"${name}\", R\"text(${text})text\"},\n")
endforeach()
file(WRITE ${OUT} "// Made by cmake/embed_texts.cmake.
#include \"${HEADER}\"

#include <utility>

namespace rhexis {

namespace {

constexpr std::pair<std::string_view, std::string_view> ${FUNCTION}_table[] = {
${table}};

}  // namespace

std::string_view ${FUNCTION}(std::string_view file) {
    for (const auto& [name, text] : ${FUNCTION}_table) {
        if (name == file) {
            return text;
        }
    }
    return {};
}

}  // namespace rhexis
")
