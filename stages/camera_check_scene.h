#pragma once
#include <map>
#include <string>

#include "stages/camera_check.h"

namespace sturm {

/// The scene of a check in the formats of other programs, and as a view of this one: contents by file name. scene.gltf
/// with scene.bin (lamps and the camera), scene.obj with scene.mtl (lamps alone; Ke is their radiance, 1), view.json
/// (sturm.render/1, which names scene.obj) and camera.json, with the aperture and focus of a thin lens where the eye is
/// one (`eye` without a cylinder; null otherwise).
std::map<std::string, std::string> camera_check_files(const CameraCheck& check, const Eye& eye,
                                                      const Json& eye_document);

}  // namespace sturm
