// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/spoken_words.hpp"

#include "lua/lua_state.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

std::map<std::string, std::string> texts_in(lua_State* L, const char* field) {
    std::map<std::string, std::string> texts;
    lua_getfield(L, -1, field);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        lua_pushvalue(L, -2);
        texts[lua_tostring(L, -1)] = lua_tostring(L, -2);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return texts;
}

}  // namespace

Result<SpokenWords> load_spoken_words(const std::string& root, const std::string& language,
                                      const std::vector<std::string>& instruments) {
    LuaOptions options;
    options.folders = {{root + "/scripts", "scripts"}};
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    SpokenWords spoken;
    const Status status = state.value().run([&](lua_State* L) {
        lua_getglobal(L, "require");
        lua_pushstring(L, "report.spoken");
        lua_call(L, 1, 1);
        lua::push(L, std::string_view(language.empty() ? "en" : language));
        lua_createtable(L, static_cast<int>(instruments.size()), 0);
        for (std::size_t i = 0; i < instruments.size(); ++i) {
            lua::push(L, std::string_view(instruments[i]));
            lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
        }
        lua_call(L, 2, 1);
        spoken.texts = texts_in(L, "texts");
        spoken.instruments = texts_in(L, "instruments");
        spoken.settings = texts_in(L, "settings");
    });
    return status ? Result<SpokenWords>(std::move(spoken)) : status.error();
}

}  // namespace rhexis
