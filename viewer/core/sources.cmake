# What the viewer's core is made of besides its bindings: `viewer_optics` answers for lines of sight and fields, `viewer_core` has the rest.
# tests/viewer/ compiles the optics once more for this machine.
file(GLOB viewer_optics CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lensmodel/*.cpp ${PROJECT_SOURCE_DIR}/conoid/tracing/*.cpp)
list(APPEND viewer_optics
  ${PROJECT_SOURCE_DIR}/conoid/blur_field/depth_analytic_field.cpp
  ${PROJECT_SOURCE_DIR}/conoid/blur_field/traced_directions.cpp
  ${PROJECT_SOURCE_DIR}/conoid/blur_field/voxel_field.cpp
  ${PROJECT_SOURCE_DIR}/conoid/blur_field/voxel_fill.cpp
  ${PROJECT_SOURCE_DIR}/conoid/blur_field/voxel_mask.cpp)
set(viewer_core ${viewer_optics}
  ${PROJECT_SOURCE_DIR}/conoid/pictures/pixel_rays.cpp
  ${PROJECT_SOURCE_DIR}/conoid/pictures/pupil_passes.cpp
  ${PROJECT_SOURCE_DIR}/conoid/pictures/sight_field.cpp
  ${PROJECT_SOURCE_DIR}/io/files/readable_text.cpp
  ${PROJECT_SOURCE_DIR}/io/files/text_encoding.cpp
  ${PROJECT_SOURCE_DIR}/io/json/suggest.cpp
  ${PROJECT_SOURCE_DIR}/io/specs/notation_parser.cpp
  ${PROJECT_SOURCE_DIR}/io/specs/notation_text.cpp
  ${PROJECT_SOURCE_DIR}/io/specs/notation_tokens.cpp
  ${PROJECT_SOURCE_DIR}/io/specs/noted_prism.cpp
  ${PROJECT_SOURCE_DIR}/pathtrace/cameras/camera_pose.cpp)
