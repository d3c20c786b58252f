// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel objects that a script holds by handle: userdata with an id and a generation, never a pointer. A handle whose
// object was closed raises a sentence.
#pragma once

#include <lauxlib.h>
#include <lua.h>

#include <memory>
#include <optional>
#include <vector>

#include "base/slot_map.hpp"
#include "lua/scene_body.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/tri_mesh.hpp"
#include "render/renderer.hpp"
#include "video/video.hpp"

namespace rhexis::lua {

struct SizedVideo {
    std::unique_ptr<Video> file{};
    int width = 0;
    int height = 0;
};

/// All objects of one Lua state.
struct Objects {
    SlotMap<TetMesh> meshes;
    SlotMap<TriMesh> sheets;
    SlotMap<std::unique_ptr<SceneBody>> scenes;
    SlotMap<Snapshot> snapshots;
    SlotMap<Image> images;
    SlotMap<std::unique_ptr<SizedVideo>> videos;
    /// The renderer of the last picture's size.
    std::optional<Renderer> renderer;
    int renderer_width = 0;
    int renderer_height = 0;
};

Objects& objects(lua_State* L);

/// A part of a scene: a solid, a tool, or a view of a solid's nodes. Its userdata keeps the scene's userdata alive.
struct PartHandle {
    SlotId scene;
    int index = 0;               ///< of WorldModel::solids, membranes or tools
    std::uint64_t revision = 0;  ///< views only: of the scene when the view was made
};

// Registered names of the classes, also what tostring shows.
inline constexpr const char* mesh_class = "rhexis.Mesh";
inline constexpr const char* sheet_class = "rhexis.Sheet";
inline constexpr const char* membrane_class = "rhexis.Membrane";
inline constexpr const char* scene_class = "rhexis.Scene";
inline constexpr const char* solid_class = "rhexis.Solid";
inline constexpr const char* tool_class = "rhexis.Tool";
inline constexpr const char* view_class = "rhexis.View";
inline constexpr const char* snapshot_class = "rhexis.Snapshot";
inline constexpr const char* image_class = "rhexis.Image";
inline constexpr const char* video_class = "rhexis.Video";

/// Makes the class's metatable: its methods, and others (__index, __gc, ...) as they are named.
void define_class(lua_State* L, const char* name, const std::vector<luaL_Reg>& methods,
                  const std::vector<luaL_Reg>& metamethods);

// Push a new handle to an object that moves into the state.
void push_mesh(lua_State* L, TetMesh mesh);
void push_sheet(lua_State* L, TriMesh sheet);
void push_scene(lua_State* L, std::unique_ptr<SceneBody> scene);
void push_snapshot(lua_State* L, Snapshot snapshot);
void push_image(lua_State* L, Image image);
void push_video(lua_State* L, std::unique_ptr<SizedVideo> video);
/// scene: stack index of the scene's userdata.
void push_part(lua_State* L, const char* class_name, int scene, int index);

// The object behind the argument, or an error that names the argument or says that it was closed.
TetMesh& check_mesh(lua_State* L, int index);
TriMesh& check_sheet(lua_State* L, int index);
SceneBody& check_scene(lua_State* L, int index);
Snapshot& check_snapshot(lua_State* L, int index);
Image& check_image(lua_State* L, int index);
SizedVideo& check_video(lua_State* L, int index);

struct ScenePart {
    SceneBody& scene;
    const PartHandle& handle;
};
ScenePart check_part(lua_State* L, int index, const char* class_name);

// __gc and close of the classes that own an object.
int close_mesh(lua_State* L);
int close_sheet(lua_State* L);
int close_scene(lua_State* L);
int close_snapshot(lua_State* L);
int close_image(lua_State* L);
int close_video(lua_State* L);

/// Raises the error of a Result.
void raise_if_failed(lua_State* L, const char* function, const Status& status);

}  // namespace rhexis::lua
