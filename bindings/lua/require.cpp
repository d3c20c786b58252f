// SPDX-License-Identifier: GPL-3.0-or-later
// require over the script folders of this state, and nothing else: no native code, no path outside.
#include <lauxlib.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/lua_state.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

constexpr const char* loaded_key = "rhexis.loaded";

bool plain_name(std::string_view name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
               c == '-';
    };
    return !name.empty() && name.size() <= 200 && std::all_of(name.begin(), name.end(), allowed) &&
           name.front() != '.' && name.back() != '.' && name.find("..") == std::string_view::npos;
}

// "surgeons.expert" is surgeons/expert.lua or surgeons/expert/init.lua of the first folder that has it.
bool push_module_chunk(lua_State* L, const std::string& name) {
    std::string relative = name;
    std::replace(relative.begin(), relative.end(), '.', '/');
    for (const ScriptFolder& folder : context(L).options.folders) {
        for (const char* ending : {".lua", "/init.lua"}) {
            const std::string path = folder.path + "/" + relative + ending;
            std::error_code ignored;
            if (std::filesystem::is_regular_file(path, ignored)) {
                load_file(L, path, folder.label + (folder.label.empty() ? "" : "/") + relative + ending);
                return true;
            }
        }
    }
    return false;
}

std::string searched(lua_State* L) {
    std::string list;
    for (const ScriptFolder& folder : context(L).options.folders) {
        list += (list.empty() ? "" : ", ") + (folder.label.empty() ? folder.path : folder.label);
    }
    return list.empty() ? "nowhere: this script has no folders to require from" : list;
}

int require(lua_State* L) {
    const std::string name = luaL_checkstring(L, 1);
    lua_settop(L, 1);
    if (!plain_name(name)) {
        return luaL_error(L, "require: '%s' is not a module name (letters, digits, _ and -, folders joined by dots)",
                          name.c_str());
    }
    lua_getfield(L, LUA_REGISTRYINDEX, loaded_key);  // index 2
    lua_getfield(L, 2, name.c_str());
    if (lua_touserdata(L, 3) == &context(L)) {
        return luaL_error(L, "require: module '%s' requires itself", name.c_str());
    }
    if (!lua_isnil(L, 3)) {
        return 1;
    }
    if (!push_module_chunk(L, name)) {
        return luaL_error(L, "require: no module '%s' in %s", name.c_str(), searched(L).c_str());
    }
    lua_pushlightuserdata(L, &context(L));  // marks a module whose file is running
    lua_setfield(L, 2, name.c_str());
    lua_pushvalue(L, 1);
    const int status = lua_pcall(L, 1, 1, 0);
    if (status == LUA_OK && lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    if (status != LUA_OK) {
        lua_pushnil(L);  // may be required again once it is mended
        lua_setfield(L, 2, name.c_str());
        return lua_error(L);
    }
    lua_pushvalue(L, -1);
    lua_setfield(L, 2, name.c_str());
    return 1;
}

}  // namespace

void open_require(lua_State* L) {
    lua_newtable(L);
    lua_setfield(L, LUA_REGISTRYINDEX, loaded_key);
    lua_register(L, "require", guarded<require>);
}

}  // namespace rhexis::lua
