#pragma once
// The part of OpenGL 3.3 core that the renderer uses: types, constants, and a table of functions
// that a context fills. With its own table the renderer compiles and links in a build without any
// GL library, and needs no GL headers.

#include <cstddef>

#include "results/gl_context.hpp"

namespace scanchor::gl {

using Enum = unsigned int;
using Uint = unsigned int;
using Sizei = int;
using Char = char;

inline constexpr Enum triangles = 0x0004, points = 0x0000;
inline constexpr Enum depth_buffer_bit = 0x0100, color_buffer_bit = 0x4000;
inline constexpr Enum depth_test = 0x0B71, blend = 0x0BE2, multisample = 0x809D;
inline constexpr Enum sample_alpha_to_coverage = 0x809E, program_point_size = 0x8642;
inline constexpr Enum polygon_offset_fill = 0x8037, lequal = 0x0203;
inline constexpr Enum src_alpha = 0x0302, one_minus_src_alpha = 0x0303, one = 1;
inline constexpr Enum array_buffer = 0x8892, element_array_buffer = 0x8893, stream_draw = 0x88E0;
inline constexpr Enum float_type = 0x1406, unsigned_byte = 0x1401, unsigned_int = 0x1405;
inline constexpr Enum vertex_shader = 0x8B31, fragment_shader = 0x8B30;
inline constexpr Enum compile_status = 0x8B81, link_status = 0x8B82;
inline constexpr Enum framebuffer = 0x8D40, read_framebuffer = 0x8CA8, draw_framebuffer = 0x8CA9;
inline constexpr Enum renderbuffer = 0x8D41, color_attachment0 = 0x8CE0, depth_attachment = 0x8D00;
inline constexpr Enum framebuffer_complete = 0x8CD5, max_samples = 0x8D57;
inline constexpr Enum rgba8 = 0x8058, depth_component32f = 0x8CAC, depth_component = 0x1902;
inline constexpr Enum rgba = 0x1908, nearest = 0x2600, linear = 0x2601;
inline constexpr Enum pack_alignment = 0x0D05, renderer_name = 0x1F01, version_name = 0x1F02;

// X(result, name, parameters)
#define SCANCHOR_GL_FUNCTIONS(X)                                                     \
  X(void, Viewport, (int, int, Sizei, Sizei))                                        \
  X(void, Enable, (Enum))                                                            \
  X(void, Disable, (Enum))                                                           \
  X(void, DepthFunc, (Enum))                                                         \
  X(void, DepthMask, (unsigned char))                                                \
  X(void, BlendFuncSeparate, (Enum, Enum, Enum, Enum))                               \
  X(void, PolygonOffset, (float, float))                                             \
  X(void, ClearColor, (float, float, float, float))                                  \
  X(void, Clear, (unsigned int))                                                     \
  X(void, PixelStorei, (Enum, int))                                                  \
  X(void, ReadPixels, (int, int, Sizei, Sizei, Enum, Enum, void*))                   \
  X(void, GetIntegerv, (Enum, int*))                                                 \
  X(const unsigned char*, GetString, (Enum))                                         \
  X(Enum, GetError, ())                                                              \
  X(void, DrawArrays, (Enum, int, Sizei))                                            \
  X(void, DrawElements, (Enum, Sizei, Enum, const void*))                            \
  X(void, GenBuffers, (Sizei, Uint*))                                                \
  X(void, BindBuffer, (Enum, Uint))                                                  \
  X(void, BufferData, (Enum, std::ptrdiff_t, const void*, Enum))                     \
  X(void, DeleteBuffers, (Sizei, const Uint*))                                       \
  X(void, GenVertexArrays, (Sizei, Uint*))                                           \
  X(void, BindVertexArray, (Uint))                                                   \
  X(void, DeleteVertexArrays, (Sizei, const Uint*))                                  \
  X(void, EnableVertexAttribArray, (Uint))                                           \
  X(void, DisableVertexAttribArray, (Uint))                                          \
  X(void, VertexAttribPointer, (Uint, int, Enum, unsigned char, Sizei, const void*)) \
  X(Uint, CreateShader, (Enum))                                                      \
  X(void, ShaderSource, (Uint, Sizei, const Char* const*, const int*))               \
  X(void, CompileShader, (Uint))                                                     \
  X(void, GetShaderiv, (Uint, Enum, int*))                                           \
  X(void, GetShaderInfoLog, (Uint, Sizei, Sizei*, Char*))                            \
  X(void, DeleteShader, (Uint))                                                      \
  X(Uint, CreateProgram, ())                                                         \
  X(void, AttachShader, (Uint, Uint))                                                \
  X(void, LinkProgram, (Uint))                                                       \
  X(void, GetProgramiv, (Uint, Enum, int*))                                          \
  X(void, DeleteProgram, (Uint))                                                     \
  X(void, UseProgram, (Uint))                                                        \
  X(int, GetUniformLocation, (Uint, const Char*))                                    \
  X(void, Uniform1f, (int, float))                                                   \
  X(void, Uniform3f, (int, float, float, float))                                     \
  X(void, UniformMatrix4fv, (int, Sizei, unsigned char, const float*))               \
  X(void, GenFramebuffers, (Sizei, Uint*))                                           \
  X(void, BindFramebuffer, (Enum, Uint))                                             \
  X(void, DeleteFramebuffers, (Sizei, const Uint*))                                  \
  X(Enum, CheckFramebufferStatus, (Enum))                                            \
  X(void, GenRenderbuffers, (Sizei, Uint*))                                          \
  X(void, BindRenderbuffer, (Enum, Uint))                                            \
  X(void, DeleteRenderbuffers, (Sizei, const Uint*))                                 \
  X(void, RenderbufferStorageMultisample, (Enum, Sizei, Enum, Sizei, Sizei))         \
  X(void, FramebufferRenderbuffer, (Enum, Enum, Enum, Uint))                         \
  X(void, BlitFramebuffer, (int, int, int, int, int, int, int, int, unsigned int, Enum))

struct Functions {
#define SCANCHOR_GL_MEMBER(result, name, parameters) result(*name) parameters = nullptr;
  SCANCHOR_GL_FUNCTIONS(SCANCHOR_GL_MEMBER)
#undef SCANCHOR_GL_MEMBER
};

/// All functions of the table from a current context. Throws Error(bad_data) naming the first that
/// is missing.
Functions load_functions(GlContext& context);

}  // namespace scanchor::gl
