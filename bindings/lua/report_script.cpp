// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/report_script.hpp"

#include "lua/json.hpp"
#include "lua/lua_state.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

/// Pictures in base64 and long series take more room and work than a step of an exercise.
constexpr LuaLimits page_limits{std::size_t{512} << 20, 4'000'000'000, 60.0};

void push_images(lua_State* L, const std::map<std::string, std::string>& images) {
    lua_createtable(L, 0, static_cast<int>(images.size()));
    for (const auto& [file, bytes] : images) {
        lua::push(L, std::string_view(file));
        lua::push(L, std::string_view(bytes));
        lua_rawset(L, -3);
    }
}

void push_html_function(lua_State* L, const std::string& module) {
    lua_getglobal(L, "require");
    lua::push(L, std::string_view(module));
    lua_call(L, 1, 1);
    if (!lua_istable(L, -1) || lua_getfield(L, -1, "html") != LUA_TFUNCTION) {
        luaL_error(L, "scripts/%s has no function html", module.c_str());
    }
}

/// push_arguments puts them on the stack and returns how many there are.
template <typename PushArguments>
Result<std::string> page(const std::string& root, const std::string& module, PushArguments push_arguments) {
    LuaOptions options;
    options.limits = page_limits;
    options.folders.push_back({root + "/scripts", "scripts"});
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    std::string page;
    const Status status = state.value().run([&](lua_State* L) {
        push_html_function(L, module);
        lua_call(L, push_arguments(L), 1);
        std::size_t size = 0;
        const char* text = lua_tolstring(L, -1, &size);
        if (text == nullptr) {
            luaL_error(L, "scripts/%s: html returned no text", module.c_str());
        }
        page.assign(text, size);
    });
    return status ? Result<std::string>(std::move(page)) : Result<std::string>(status.error());
}

}  // namespace

Result<std::string> report_html(const std::string& root, const nlohmann::json& report, const nlohmann::json& series,
                                const std::map<std::string, std::string>& images) {
    return page(root, "report", [&](lua_State* L) {
        lua::push_json(L, report);
        lua::push_json(L, series);
        push_images(L, images);
        return 3;
    });
}

Result<std::string> page_html(const std::string& root, const std::string& module, const nlohmann::json& data) {
    return page(root, module, [&](lua_State* L) {
        lua::push_json(L, data);
        return 1;
    });
}

}  // namespace rhexis
