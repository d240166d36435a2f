#pragma once
// The renderer's six shaders, GLSL 3.30.

namespace scanchor {

inline constexpr const char* mesh_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 matrix;
flat out vec4 vertex_color;
out vec3 vertex_normal;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  vertex_color = color;
  vertex_normal = normal;
}
)";

// Two-sided: a scanned surface has no inside. A key light over the viewer's left shoulder, light
// from above, and an even rest; a face keeps its hue, so that the legend's colour is found again on
// it. A normal of zero: the plain colour.
inline constexpr const char* mesh_fragment_shader = R"(#version 330 core
flat in vec4 vertex_color;
in vec3 vertex_normal;
uniform vec3 to_eye;
uniform vec3 key_light;
out vec4 pixel;
void main() {
  float light = 1.0;
  if (dot(vertex_normal, vertex_normal) > 0.1) {
    vec3 n = normalize(vertex_normal);
    if (dot(n, to_eye) < 0.0) n = -n;
    light = 0.70 + 0.26 * max(dot(n, key_light), 0.0) + 0.12 * (0.5 + 0.5 * n.z);
  }
  pixel = vec4(min(vertex_color.rgb * light, vec3(1.0)), vertex_color.a);
}
)";

inline constexpr const char* point_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 color;
uniform mat4 matrix;
uniform float least_px;
uniform float most_px;
uniform float size_at_one;
flat out vec3 point_color;
flat out float diameter;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  diameter = clamp(size_at_one / max(gl_Position.w, 1e-6), least_px, max(least_px, most_px));
  gl_PointSize = diameter + 1.0;  // Room for the soft edge.
  point_color = color.rgb;
}
)";

// A core profile has no round points: the disc is cut out, its edge given to the samples by its
// coverage.
inline constexpr const char* point_fragment_shader = R"(#version 330 core
flat in vec3 point_color;
flat in float diameter;
out vec4 pixel;
void main() {
  float from_center = length(gl_PointCoord - vec2(0.5)) * (diameter + 1.0);
  float cover = clamp(0.5 * diameter - from_center + 0.5, 0.0, 1.0);
  if (cover < 0.1) discard;
  pixel = vec4(point_color, cover);
}
)";

inline constexpr const char* line_vertex_shader = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 2) in vec4 color;
flat out vec4 line_color;
void main() {
  gl_Position = clip;
  line_color = color;
}
)";

inline constexpr const char* line_fragment_shader = R"(#version 330 core
flat in vec4 line_color;
out vec4 pixel;
void main() { pixel = line_color; }
)";

}  // namespace scanchor
