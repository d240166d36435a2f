#include "results/gl_draw.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "results/gl_functions.hpp"
#include "results/gl_geometry.hpp"
#include "results/gl_shaders.hpp"

namespace scanchor {
namespace {

using gl::Uint;

/// What goes to the GPU: position relative to the eye's target (float is exact enough there),
/// normal, colour.
struct MeshVertex {
  std::array<float, 3> position, normal;
  Color color;
};
struct PointVertex {
  std::array<float, 3> position;
  Color color;
};
std::array<float, 3> to_float(const Eigen::Vector3d& v) {
  return {float(v.x()), float(v.y()), float(v.z())};
}

class Renderer {
 public:
  Renderer() : context_(make_gl_context()) {
    context_->make_current();
    gl_ = gl::load_functions(*context_);
    mesh_program_ = link(mesh_vertex_shader, mesh_fragment_shader);
    point_program_ = link(point_vertex_shader, point_fragment_shader);
    line_program_ = link(line_vertex_shader, line_fragment_shader);
    gl_.GenVertexArrays(1, &array_);
    gl_.GenBuffers(1, &vertices_);
    gl_.GenBuffers(1, &indices_);
    int samples = 0;
    gl_.GetIntegerv(gl::max_samples, &samples);
    most_samples_ = std::max(samples, 1);
    context_->release();
  }
  // The process keeps its one renderer until it ends; drivers may be gone by the time static
  // objects are destroyed.

  Frame draw(const Drawing& drawing, const Projection& projection, int width, int height,
             int samples, Color background) {
    context_->make_current();
    struct Release {
      GlContext& context;
      ~Release() { context.release(); }
    } release{*context_};
    origin_ = projection.eye() +
              projection.forward() * (0.5 * (projection.near_plane() + projection.far_plane()));
    prepare_targets(width, height, std::min(samples, most_samples_));
    gl_.BindFramebuffer(gl::framebuffer, multi_.framebuffer);
    gl_.Viewport(0, 0, width, height);
    gl_.ClearColor(float(background.r) / 255.0F, float(background.g) / 255.0F,
                   float(background.b) / 255.0F, 1.0F);
    gl_.DepthMask(1);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    gl_.Enable(gl::depth_test);
    gl_.DepthFunc(gl::lequal);
    gl_.Enable(gl::multisample);
    gl_.Enable(gl::program_point_size);
    gl_.BindVertexArray(array_);

    draw_meshes(drawing, projection, false);
    if (samples_ > 1 && nothing_over_points(drawing)) {
      // Points smooth their own edges: drawn once a pixel, after the samples of all else have
      // become pixels, they cost half.
      draw_lines(drawing, projection, width, height);
      resolve(width, height);
      gl_.BindFramebuffer(gl::framebuffer, single_.framebuffer);
      draw_points(drawing, projection, height, false);
    } else {
      draw_points(drawing, projection, height, true);
      draw_lines(drawing, projection, width, height);
      draw_meshes(drawing, projection, true);
      resolve(width, height);
    }
    return read(projection, width, height);
  }

  std::string driver() {
    context_->make_current();
    const auto text = [&](gl::Enum name) {
      return std::string(reinterpret_cast<const char*>(gl_.GetString(name)));
    };
    std::string result = text(gl::renderer_name) + ", " + text(gl::version_name);
    context_->release();
    return result;
  }

 private:
  struct Target {
    Uint framebuffer = 0, color = 0, depth = 0;
  };

  Uint shader(gl::Enum kind, const char* source) {
    const Uint id = gl_.CreateShader(kind);
    gl_.ShaderSource(id, 1, &source, nullptr);
    gl_.CompileShader(id);
    int good = 0;
    gl_.GetShaderiv(id, gl::compile_status, &good);
    if (good == 0) {
      std::array<char, 1024> log{};
      gl_.GetShaderInfoLog(id, int(log.size()), nullptr, log.data());
      fail_data("", "", std::string("the OpenGL driver refused a shader: ") + log.data());
    }
    return id;
  }

  Uint link(const char* vertex, const char* fragment) {
    const Uint program = gl_.CreateProgram();
    for (const Uint id :
         {shader(gl::vertex_shader, vertex), shader(gl::fragment_shader, fragment)}) {
      gl_.AttachShader(program, id);
      gl_.DeleteShader(id);
    }
    gl_.LinkProgram(program);
    int good = 0;
    gl_.GetProgramiv(program, gl::link_status, &good);
    if (good == 0) fail_data("", "", "the OpenGL driver could not link a shader program");
    return program;
  }

  Target make_target(int width, int height, int samples) {
    Target target;
    gl_.GenFramebuffers(1, &target.framebuffer);
    gl_.GenRenderbuffers(1, &target.color);
    gl_.GenRenderbuffers(1, &target.depth);
    gl_.BindFramebuffer(gl::framebuffer, target.framebuffer);
    gl_.BindRenderbuffer(gl::renderbuffer, target.color);
    gl_.RenderbufferStorageMultisample(gl::renderbuffer, samples, gl::rgba8, width, height);
    gl_.BindRenderbuffer(gl::renderbuffer, target.depth);
    gl_.RenderbufferStorageMultisample(gl::renderbuffer, samples, gl::depth_component32f, width,
                                       height);
    gl_.FramebufferRenderbuffer(gl::framebuffer, gl::color_attachment0, gl::renderbuffer,
                                target.color);
    gl_.FramebufferRenderbuffer(gl::framebuffer, gl::depth_attachment, gl::renderbuffer,
                                target.depth);
    if (gl_.CheckFramebufferStatus(gl::framebuffer) != gl::framebuffer_complete) {
      fail_data("", "",
                "the OpenGL driver has no framebuffer of " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels with " + std::to_string(samples) + " samples",
                "ask for a smaller picture");
    }
    return target;
  }

  void drop_target(Target& target) {
    gl_.DeleteFramebuffers(1, &target.framebuffer);
    gl_.DeleteRenderbuffers(1, &target.color);
    gl_.DeleteRenderbuffers(1, &target.depth);
    target = {};
  }

  void prepare_targets(int width, int height, int samples) {
    if (width == width_ && height == height_ && samples == samples_) return;
    drop_target(multi_);
    drop_target(single_);
    width_ = height_ = samples_ = 0;
    multi_ = make_target(width, height, samples > 1 ? samples : 0);
    single_ = make_target(width, height, 0);
    width_ = width;
    height_ = height;
    samples_ = samples;
  }

  void upload(gl::Enum kind, Uint buffer, const void* data, std::size_t bytes) {
    gl_.BindBuffer(kind, buffer);
    gl_.BufferData(kind, std::ptrdiff_t(bytes), data, gl::stream_draw);
  }

  void attribute(Uint index, int count, gl::Enum type, std::size_t stride, std::size_t offset) {
    gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(index, count, type, type == gl::unsigned_byte ? 1 : 0, int(stride),
                            reinterpret_cast<const void*>(offset));
  }

  void set_matrix(Uint program, const Projection& projection) {
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.block<3, 1>(0, 3) = origin_;
    const Eigen::Matrix4f matrix = (projection.matrix() * shift).cast<float>();
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(program, "matrix"), 1, 0, matrix.data());
  }

  void set_direction(Uint program, const char* name, const Eigen::Vector3d& d) {
    gl_.Uniform3f(gl_.GetUniformLocation(program, name), float(d.x()), float(d.y()), float(d.z()));
  }

  void draw_mesh(const DrawnMesh& mesh) {
    std::vector<MeshVertex> vertices(mesh.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      vertices[i].position = to_float(mesh.vertices[i] - origin_);
      vertices[i].normal =
          mesh.normals.empty() ? std::array<float, 3>{0, 0, 0} : to_float(mesh.normals[i]);
      vertices[i].color = mesh.colors[i];
    }
    upload(gl::array_buffer, vertices_, vertices.data(), vertices.size() * sizeof(MeshVertex));
    upload(gl::element_array_buffer, indices_, mesh.triangles.data(),
           mesh.triangles.size() * sizeof(Eigen::Vector3i));
    attribute(0, 3, gl::float_type, sizeof(MeshVertex), 0);
    attribute(1, 3, gl::float_type, sizeof(MeshVertex), offsetof(MeshVertex, normal));
    attribute(2, 4, gl::unsigned_byte, sizeof(MeshVertex), offsetof(MeshVertex, color));
    gl_.DrawElements(gl::triangles, int(3 * mesh.triangles.size()), gl::unsigned_int, nullptr);
  }

  void draw_meshes(const Drawing& drawing, const Projection& projection, bool translucent) {
    std::vector<DrawnMesh> filled;
    std::vector<std::pair<double, const DrawnMesh*>> order;
    const auto want = [&](const DrawnMesh& mesh) {
      if (mesh.triangles.empty() || (mesh.colors[0].a < 255) != translucent) return;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& v : mesh.vertices) sum += v;
      const Eigen::Vector3d center = sum / double(mesh.vertices.size());
      order.emplace_back(-projection.forward().dot(center - projection.eye()), &mesh);
    };
    filled.reserve(drawing.polygons.size());
    for (const DrawnPolygon& polygon : drawing.polygons) {
      if (polygon.fill.a == 0) continue;
      filled.push_back(filling(polygon));
    }
    for (const DrawnMesh& mesh : drawing.meshes) want(mesh);
    for (const DrawnMesh& mesh : filled) want(mesh);
    if (order.empty()) return;
    if (translucent) {  // Far ones first.
      std::stable_sort(order.begin(), order.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      gl_.Enable(gl::blend);
      gl_.BlendFuncSeparate(gl::src_alpha, gl::one_minus_src_alpha, gl::one,
                            gl::one_minus_src_alpha);
      gl_.DepthMask(0);
    }
    gl_.Enable(gl::polygon_offset_fill);
    gl_.PolygonOffset(1.0F, 1.0F);
    gl_.UseProgram(mesh_program_);
    set_matrix(mesh_program_, projection);
    set_direction(mesh_program_, "to_eye", -projection.forward());
    set_direction(
        mesh_program_, "key_light",
        (-projection.forward() - 0.55 * projection.right() + 0.9 * projection.up()).normalized());
    for (const auto& [distance, mesh] : order) draw_mesh(*mesh);
    gl_.Disable(gl::polygon_offset_fill);
    gl_.Disable(gl::blend);
    gl_.DepthMask(1);
  }

  /// Whether points may come last: nothing translucent lies over them, no line shows through them.
  static bool nothing_over_points(const Drawing& drawing) {
    const auto solid = [](Color color) { return color.a == 0 || color.a == 255; };
    return std::all_of(
               drawing.meshes.begin(), drawing.meshes.end(),
               [&](const DrawnMesh& m) { return m.colors.empty() || solid(m.colors[0]); }) &&
           std::all_of(drawing.polygons.begin(), drawing.polygons.end(),
                       [&](const DrawnPolygon& p) { return solid(p.fill); }) &&
           std::none_of(drawing.lines.begin(), drawing.lines.end(),
                        [](const DrawnLines& l) { return l.hidden; });
  }

  /// `samples`: a disc's edge is given to the samples of its pixels; otherwise it is blended.
  void draw_points(const Drawing& drawing, const Projection& projection, int height, bool samples) {
    if (drawing.points.empty()) return;
    gl_.UseProgram(point_program_);
    set_matrix(point_program_, projection);
    if (samples) {
      gl_.Enable(gl::sample_alpha_to_coverage);
    } else {
      gl_.Enable(gl::blend);
      gl_.BlendFuncSeparate(gl::src_alpha, gl::one_minus_src_alpha, gl::one,
                            gl::one_minus_src_alpha);
    }
    gl_.DisableVertexAttribArray(1);
    for (const DrawnPoints& group : drawing.points) {
      // In perspective clip w is the distance, so size in pixels = pixels per metre at 1 m * size /
      // w.
      gl_.Uniform1f(gl_.GetUniformLocation(point_program_, "least_px"), float(group.size_px));
      gl_.Uniform1f(gl_.GetUniformLocation(point_program_, "size_at_one"),
                    float(group.size_m * projection.pixels_per_metre(1.0)));
      gl_.Uniform1f(gl_.GetUniformLocation(point_program_, "most_px"), float(height) / 20.0F);
      constexpr std::size_t chunk = std::size_t(1) << 20U;  // Bounds the memory of huge clouds.
      std::vector<PointVertex> vertices;
      for (std::size_t begin = 0; begin < group.positions.size(); begin += chunk) {
        const std::size_t count = std::min(chunk, group.positions.size() - begin);
        vertices.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
          vertices[i] = {to_float(group.positions[begin + i] - origin_), group.colors[begin + i]};
        }
        upload(gl::array_buffer, vertices_, vertices.data(), count * sizeof(PointVertex));
        attribute(0, 3, gl::float_type, sizeof(PointVertex), 0);
        attribute(2, 4, gl::unsigned_byte, sizeof(PointVertex), offsetof(PointVertex, color));
        gl_.DrawArrays(gl::points, 0, int(count));
      }
    }
    gl_.Disable(samples ? gl::sample_alpha_to_coverage : gl::blend);
  }

  /// Core profiles promise lines of one pixel only, so each piece becomes two triangles in clip
  /// space.
  void draw_lines(const Drawing& drawing, const Projection& projection, int width, int height) {
    gl_.UseProgram(line_program_);
    gl_.DisableVertexAttribArray(1);
    for (const bool hidden : {false, true}) {
      const std::vector<LineVertex> vertices =
          line_vertices(drawing, projection, width, height, hidden);
      if (vertices.empty()) continue;
      if (hidden) gl_.Disable(gl::depth_test);
      gl_.Enable(gl::blend);
      gl_.BlendFuncSeparate(gl::src_alpha, gl::one_minus_src_alpha, gl::one,
                            gl::one_minus_src_alpha);
      upload(gl::array_buffer, vertices_, vertices.data(), vertices.size() * sizeof(LineVertex));
      attribute(0, 4, gl::float_type, sizeof(LineVertex), 0);
      attribute(2, 4, gl::unsigned_byte, sizeof(LineVertex), offsetof(LineVertex, color));
      gl_.DrawArrays(gl::triangles, 0, int(vertices.size()));
      gl_.Disable(gl::blend);
      gl_.Enable(gl::depth_test);
    }
  }

  /// Samples become pixels.
  void resolve(int width, int height) {
    gl_.BindFramebuffer(gl::read_framebuffer, multi_.framebuffer);
    gl_.BindFramebuffer(gl::draw_framebuffer, single_.framebuffer);
    gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                        gl::color_buffer_bit | gl::depth_buffer_bit, gl::nearest);
  }

  Frame read(const Projection& projection, int width, int height) {
    gl_.BindFramebuffer(gl::framebuffer, single_.framebuffer);
    gl_.PixelStorei(gl::pack_alignment, 1);
    const std::size_t row = std::size_t(width);
    const std::size_t pixels = row * std::size_t(height);
    rgba_.resize(4 * pixels);
    depth_.resize(pixels);
    // The formats of the buffers themselves: reading them is a plain copy.
    gl_.ReadPixels(0, 0, width, height, gl::rgba, gl::unsigned_byte, rgba_.data());
    gl_.ReadPixels(0, 0, width, height, gl::depth_component, gl::float_type, depth_.data());
    if (const gl::Enum error = gl_.GetError(); error != 0) {
      fail_data("", "", "OpenGL reported error " + std::to_string(error) + " while drawing");
    }
    Frame frame;
    frame.image = {width, height, std::vector<std::uint8_t>(3 * pixels)};
    frame.distance.resize(pixels);
    parallel_blocks(std::size_t(height), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y) {  // OpenGL's first row is the lowest.
        const std::size_t from = (std::size_t(height) - 1 - y) * row;
        for (std::size_t x = 0; x < row; ++x) {
          std::memcpy(&frame.image.rgb[3 * (y * row + x)], &rgba_[4 * (from + x)], 3);
          const float depth = depth_[from + x];
          frame.distance[y * row + x] =
              depth < 1.0F ? float(projection.distance_of_depth(double(depth))) : 0.0F;
        }
      }
    });
    return frame;
  }

  std::unique_ptr<GlContext> context_;
  gl::Functions gl_;
  Uint mesh_program_ = 0, point_program_ = 0, line_program_ = 0;
  Uint array_ = 0, vertices_ = 0, indices_ = 0;
  Target multi_, single_;
  int width_ = 0, height_ = 0, samples_ = 0, most_samples_ = 1;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<std::uint8_t> rgba_;
  std::vector<float> depth_;
};

std::mutex renderer_mutex;

Renderer& renderer() {
  static auto* const one = new Renderer;  // Never destroyed, see there.
  return *one;
}

}  // namespace

Frame draw_with_gl(const Drawing& drawing, const Projection& projection, int width, int height,
                   int samples, Color background) {
  const std::lock_guard lock(renderer_mutex);
  return renderer().draw(drawing, projection, width, height, samples, background);
}

std::string gl_driver() {
  const std::lock_guard lock(renderer_mutex);
  return renderer().driver();
}

}  // namespace scanchor
