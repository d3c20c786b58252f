// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/objects.hpp"

#include <new>
#include <string>
#include <type_traits>

#include "lua/context.hpp"
#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

static_assert(std::is_trivially_destructible_v<PartHandle> && std::is_trivially_destructible_v<SlotId>);

template <typename T>
T* new_handle(lua_State* L, const char* class_name, const T& value, int user_values) {
    void* memory = lua_newuserdatauv(L, sizeof(T), user_values);
    T* handle = new (memory) T(value);
    luaL_setmetatable(L, class_name);
    return handle;
}

// The handle is made first: if Lua runs out of memory there, nothing is lost.
template <typename T>
void push_object(lua_State* L, const char* class_name, SlotMap<T>& map, T object) {
    SlotId* id = new_handle(L, class_name, SlotId{}, 0);
    *id = map.insert(std::move(object));
}

template <typename T>
T& check_object(lua_State* L, int index, const char* class_name, SlotMap<T>& map) {
    const SlotId id = *static_cast<const SlotId*>(luaL_checkudata(L, index, class_name));
    T* object = map.find(id);
    if (object == nullptr) {
        raise(L, std::string("this ") + class_name + " was closed");
    }
    return *object;
}

template <typename T>
int close_object(lua_State* L, const char* class_name, SlotMap<T>& map) {
    map.erase(*static_cast<const SlotId*>(luaL_checkudata(L, 1, class_name)));
    return 0;
}

int show_name(lua_State* L) {
    lua_pushvalue(L, lua_upvalueindex(1));
    return 1;
}

}  // namespace

Objects& objects(lua_State* L) {
    Context& c = context(L);
    if (!c.objects) {
        c.objects = std::make_shared<Objects>();
    }
    return *c.objects;
}

void define_class(lua_State* L, const char* name, const std::vector<luaL_Reg>& methods,
                  const std::vector<luaL_Reg>& metamethods) {
    luaL_newmetatable(L, name);
    push_library(L, methods);
    lua_setfield(L, -2, "__index");
    lua_pushstring(L, name);
    lua_pushcclosure(L, show_name, 1);
    lua_setfield(L, -2, "__tostring");
    for (const luaL_Reg& one : metamethods) {
        lua_pushcfunction(L, one.func);
        lua_setfield(L, -2, one.name);
    }
    lua_pushliteral(L, "locked");
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

void push_mesh(lua_State* L, TetMesh mesh) { push_object(L, mesh_class, objects(L).meshes, std::move(mesh)); }
void push_sheet(lua_State* L, TriMesh sheet) { push_object(L, sheet_class, objects(L).sheets, std::move(sheet)); }
void push_scene(lua_State* L, std::unique_ptr<SceneBody> scene) {
    push_object(L, scene_class, objects(L).scenes, std::move(scene));
}
void push_snapshot(lua_State* L, Snapshot snapshot) {
    push_object(L, snapshot_class, objects(L).snapshots, std::move(snapshot));
}
void push_image(lua_State* L, Image image) { push_object(L, image_class, objects(L).images, std::move(image)); }
void push_video(lua_State* L, std::unique_ptr<SizedVideo> video) {
    push_object(L, video_class, objects(L).videos, std::move(video));
}

void push_part(lua_State* L, const char* class_name, int scene, int index) {
    scene = lua_absindex(L, scene);
    const SlotId id = *static_cast<const SlotId*>(luaL_checkudata(L, scene, scene_class));
    const std::uint64_t revision = check_scene(L, scene).revision();
    new_handle(L, class_name, PartHandle{id, index, revision}, 1);
    lua_pushvalue(L, scene);
    lua_setiuservalue(L, -2, 1);
}

TetMesh& check_mesh(lua_State* L, int index) { return check_object(L, index, mesh_class, objects(L).meshes); }
TriMesh& check_sheet(lua_State* L, int index) { return check_object(L, index, sheet_class, objects(L).sheets); }
SceneBody& check_scene(lua_State* L, int index) { return *check_object(L, index, scene_class, objects(L).scenes); }
Snapshot& check_snapshot(lua_State* L, int index) {
    return check_object(L, index, snapshot_class, objects(L).snapshots);
}
Image& check_image(lua_State* L, int index) { return check_object(L, index, image_class, objects(L).images); }
SizedVideo& check_video(lua_State* L, int index) { return *check_object(L, index, video_class, objects(L).videos); }

ScenePart check_part(lua_State* L, int index, const char* class_name) {
    const auto& handle = *static_cast<const PartHandle*>(luaL_checkudata(L, index, class_name));
    std::unique_ptr<SceneBody>* scene = objects(L).scenes.find(handle.scene);
    if (scene == nullptr) {
        raise(L, std::string("the scene of this ") + class_name + " was closed");
    }
    return {**scene, handle};
}

int close_mesh(lua_State* L) { return close_object(L, mesh_class, objects(L).meshes); }
int close_sheet(lua_State* L) { return close_object(L, sheet_class, objects(L).sheets); }
int close_scene(lua_State* L) { return close_object(L, scene_class, objects(L).scenes); }
int close_snapshot(lua_State* L) { return close_object(L, snapshot_class, objects(L).snapshots); }
int close_image(lua_State* L) { return close_object(L, image_class, objects(L).images); }
int close_video(lua_State* L) { return close_object(L, video_class, objects(L).videos); }

void raise_if_failed(lua_State* L, const char* function, const Status& status) {
    if (!status) {
        raise(L, std::string(function) + ": " + status.error().text());
    }
}

}  // namespace rhexis::lua
