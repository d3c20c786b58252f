---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---Pictures and videos of scenes, drawn without a window.
---@class rhexis.render
local render = {}

---@class rhexis.DrawOptions
---@field width? integer # [pixels]; 16 to 4096; default 640
---@field height? integer # [pixels]; 16 to 4096; default 480
---@field camera? rhexis.CameraOptions # default the operating microscope over the eye, or a view that frames the bodies

---@class rhexis.CameraOptions
---@field eye? rhexis.Vec3 # where the picture is taken from [mm]
---@field target? rhexis.Vec3 # what its centre shows [mm]
---@field up? rhexis.Vec3 # what points up in it
---@field field? number # height of what it shows, at the target [mm]; 0.01 to 1000

---Draws a scene as it is now.
---```lua
---local scene = rhexis.scene.create()
---scene:add_solid { mesh = rhexis.mesh.bar() }
---local image = rhexis.render.draw(scene, { width = 64, height = 48, camera = { eye = { 4, -40, 20 } } })
---assert(image:width() == 64)
---```
---@param scene rhexis.Scene
---@param options? rhexis.DrawOptions
---@return rhexis.Image
function render.draw(scene, options) end

---@class rhexis.VideoOptions
---@field width? integer # of every image [pixels]; 16 to 4096; default 640
---@field height? integer # of every image [pixels]; 16 to 4096; default 480
---@field frames_per_second? number # 1 to 1000; default 25

---Starts an MP4 file; it appears under its name once it is finished.
---```lua
---local scene = rhexis.scene.create()
---local path = os.tmpname() .. ".mp4"
---local video = rhexis.render.video(path, { width = 64, height = 48 })
---for _ = 1, 5 do
---    scene:step()
---    video:add(rhexis.render.draw(scene, { width = 64, height = 48 }))
---end
---video:finish()
---os.remove(path)
---```
---@param path string
---@param options? rhexis.VideoOptions
---@return rhexis.Video
function render.video(path, options) end

---A picture.
---@class rhexis.Image
local Image = {}

---[pixels]
---```lua
---assert(rhexis.render.draw(rhexis.scene.create(), { width = 32 }):width() == 32)
---```
---@return integer
function Image:width() end

---[pixels]
---```lua
---assert(rhexis.render.draw(rhexis.scene.create(), { height = 32 }):height() == 32)
---```
---@return integer
function Image:height() end

---Red, green and blue of a pixel, 0 to 255.
---```lua
---local red, green, blue = rhexis.render.draw(rhexis.scene.create()):pixel(1, 1)
---assert(red <= 255 and green <= 255 and blue <= 255)
---```
---@param column integer # from 1 at the left
---@param row integer # from 1 at the top
---@return integer red
---@return integer green
---@return integer blue
function Image:pixel(column, row) end

---Writes a PNG file.
---```lua
---local path = os.tmpname() .. ".png"
---rhexis.render.draw(rhexis.scene.create(), { width = 32, height = 32 }):write_png(path)
---os.remove(path)
---```
---@param path string
function Image:write_png(path) end

---Frees it now.
---```lua
---rhexis.render.draw(rhexis.scene.create(), { width = 32, height = 32 }):close()
---```
function Image:close() end

---A video that is being written; see rhexis.render.video.
---@class rhexis.Video
local Video = {}

---Appends an image of the video's size.
---```lua
---local path = os.tmpname() .. ".mp4"
---local video = rhexis.render.video(path, { width = 64, height = 64 })
---video:add(rhexis.render.draw(rhexis.scene.create(), { width = 64, height = 64 }))
---video:finish()
---os.remove(path)
---```
---@param image rhexis.Image
function Video:add(image) end

---Completes the file and closes the video. A video that is not finished leaves no file.
---```lua
---local path = os.tmpname() .. ".mp4"
---local video = rhexis.render.video(path, { width = 64, height = 64 })
---video:add(rhexis.render.draw(rhexis.scene.create(), { width = 64, height = 64 }))
---video:finish()
---assert(not pcall(video.finish, video))
---os.remove(path)
---```
function Video:finish() end

rhexis.render = render
