#include "app/nff/read.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/nff/write_scn.h"
#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"

namespace alhazen {
namespace {

const std::string kView = "v from 0 -8 3 at 0 0 1 up 0 0 1 angle 45 hither 1 resolution 65 65\n";
const std::string kFill = "f 1 0.5 0.25 0.75 0 0 0 0\n";

struct Read {
  SourceManager sources;
  DiagnosticSink sink;
  std::optional<NffScene> scene;

  explicit Read(std::string text, const NffLimits& limits = {}) {
    scene = read_nff(sources.add("a.nff", std::move(text)), sources, sink, limits);
  }
  std::string errors() const { return render_text(sink, sources); }
};

TEST(NffRead, EveryNumberComesToItsPlace) {
  const Read read(
      "v from 1 2 3 at 4 5 6 up 7 8 9 angle 10 hither 11 resolution 12 13\n"
      "b .1 .2 .3 l 1 2 3 l 4 5 6 .7 .8 .9\n"
      "f .1 .2 .3 .4 .5 6 .7 1.8 s 1 2 3 4 c 1 2 3 4 5 6 7 8\n"
      "p 3 1 0 0 0 1 0 0 0 1 pp 3 1 0 0 1 2 3 0 1 0 4 5 6 0 0 1 7 8 9");
  ASSERT_TRUE(read.scene) << read.errors();
  const NffScene& scene = *read.scene;
  EXPECT_EQ(scene.view.from, Vec3d(1, 2, 3));
  EXPECT_EQ(scene.view.at, Vec3d(4, 5, 6));
  EXPECT_EQ(scene.view.up, Vec3d(7, 8, 9));
  EXPECT_EQ(scene.view.angle, 10);
  EXPECT_EQ(scene.view.width, 12);
  EXPECT_EQ(scene.view.height, 13);
  EXPECT_EQ(scene.background, Rgbd(0.1, 0.2, 0.3));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].position, Vec3d(1, 2, 3));
  EXPECT_FALSE(scene.lights[0].color);
  EXPECT_EQ(scene.lights[1].color, Rgbd(0.7, 0.8, 0.9));
  ASSERT_EQ(scene.fills.size(), 1u);
  const NffFill& fill = scene.fills[0];
  EXPECT_EQ(fill.color, Rgbd(0.1, 0.2, 0.3));
  EXPECT_EQ(fill.diffuse, 0.4);
  EXPECT_EQ(fill.specular, 0.5);
  EXPECT_EQ(fill.shine, 6);
  EXPECT_EQ(fill.transmittance, 0.7);
  EXPECT_EQ(fill.ior, 1.8);
  EXPECT_EQ(fill.line, 3u);
  ASSERT_EQ(scene.runs.size(), 1u);
  const auto& shapes = scene.runs[0].shapes;
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_EQ(std::get<NffSphere>(shapes[0]).radius, 4);
  const auto& cone = std::get<NffCone>(shapes[1]);
  EXPECT_EQ(cone.base, Vec3d(1, 2, 3));
  EXPECT_EQ(cone.base_radius, 4);
  EXPECT_EQ(cone.apex, Vec3d(5, 6, 7));
  EXPECT_EQ(cone.apex_radius, 8);
  EXPECT_FALSE(std::get<NffTriangle>(shapes[2]).normals);
  const auto& patch = std::get<NffTriangle>(shapes[3]);
  EXPECT_EQ(patch.corners[1], Vec3d(0, 1, 0));
  EXPECT_EQ((*patch.normals)[1], Vec3d(4, 5, 6));
}

TEST(NffRead, RunsFollowTheFills) {
  const Read read(kView + "f 1 0 0 1 0 0 0 0 s 0 0 0 1 s 0 0 1 1 f 0 1 0 1 0 0 0 0 s 0 0 2 1 " +
                  "f 1 0 0 1 0 0 0 0 s 0 0 3 1 f 0 0 1 1 0 0 0 0");
  ASSERT_TRUE(read.scene) << read.errors();
  ASSERT_EQ(read.scene->fills.size(), 2u);
  ASSERT_EQ(read.scene->runs.size(), 3u);
  EXPECT_EQ(read.scene->runs[0].fill, 0u);
  EXPECT_EQ(read.scene->runs[0].shapes.size(), 2u);
  EXPECT_EQ(read.scene->runs[1].fill, 1u);
  EXPECT_EQ(read.scene->runs[2].fill, 0u);
}

TEST(NffRead, Limits) {
  std::string text = kView + kFill;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("s {} 0 0 1\n", i);
  NffLimits limits;
  limits.shapes = 9;  // and one run
  EXPECT_TRUE(Read(text, limits).scene);
  limits.shapes = 8;
  const Read shapes(text, limits);
  ASSERT_EQ(shapes.sink.error_count(), 1u);
  EXPECT_EQ(shapes.sink.diagnostics()[0].kind, DiagnosticKind::import_too_many);
  EXPECT_EQ(shapes.sink.code(), ErrorCode::limit);

  limits.polygon_vertices = 3;
  const Read polygon(kView + kFill + "p 4 0 0 0 1 0 0 1 1 0 0 1 0", limits);
  EXPECT_EQ(polygon.sink.error_count(), 1u) << polygon.errors();
}

TEST(NffRead, ABinaryFileIsNoText) {
  const Read read(kView + std::string("s\0", 2));
  ASSERT_EQ(read.sink.error_count(), 1u);
  EXPECT_EQ(read.sink.diagnostics()[0].kind, DiagnosticKind::binary_file);
}

TEST(NffRead, StopsAfterTwentyErrors) {
  std::string text = kView + kFill;
  for (int i = 0; i < 50; ++i)
    text += "s 0 0 0 0\n";
  const Read read(text);
  EXPECT_EQ(read.sink.error_count(), 20u);
  EXPECT_TRUE(read.sink.truncated());
}

TEST(NffWrite, LightsWithoutAColourShareOneOverTheRootOfTheirNumber) {
  const std::string four = "l 0 0 1 l 0 0 2 l 0 0 3 l 0 0 4 l 0 0 5 1 1 0\n";
  const Read read(kView + four);
  ASSERT_TRUE(read.scene) << read.errors();
  const std::string scn = write_scn(*read.scene, "a.nff");
  EXPECT_NE(scn.find("position <0, 4, 0>  intensity rgb(0.5)  falloff none"), scn.npos) << scn;
  EXPECT_NE(scn.find("position <0, 5, 0>  intensity rgb(1, 1, 0)"), scn.npos) << scn;
}

// tan(fov/2) = tan(angle/2) W/(H - 1): with angle = 90 and 3 rows of 4 pixels it is 2.
TEST(NffWrite, TheAngleIsBetweenCentresOfPixels) {
  const Read read("v from 0 0 5 at 0 0 0 up 0 1 0 angle 90 hither 1 resolution 4 3");
  ASSERT_TRUE(read.scene) << read.errors();
  const std::string scn = write_scn(*read.scene, "a.nff");
  const std::size_t at = scn.find("fov ");
  ASSERT_NE(at, scn.npos);
  // 2 atan 2, three correctly rounded steps and one of the library away.
  EXPECT_NEAR(std::stod(scn.substr(at + 4)), 126.86989764584402, 1e-13);
}

// A cube around the origin, each face counterclockwise from outside in NFF's right-handed frame.
// Normals of the scene's triangles are cross(b - a, c - a) by numbers, and what a triangle bends
// light into lies behind it.
TEST(NffWrite, FrontsStayFronts) {
  const Read read(kView + kFill +
                  "p 4 -1 -1 -1  -1 1 -1  1 1 -1  1 -1 -1\n"
                  "p 4 -1 -1 1  1 -1 1  1 1 1  -1 1 1\n"
                  "p 4 -1 -1 -1  1 -1 -1  1 -1 1  -1 -1 1\n"
                  "p 4 -1 1 -1  -1 1 1  1 1 1  1 1 -1\n"
                  "p 4 -1 -1 -1  -1 -1 1  -1 1 1  -1 1 -1\n"
                  "p 4 1 -1 -1  1 1 -1  1 1 1  1 -1 1\n");
  ASSERT_TRUE(read.scene) << read.errors();
  SourceManager sources;
  DiagnosticSink sink;
  const FileId file = sources.add("a.scn", write_scn(*read.scene, "a.nff"));
  const auto evaluation = parser::evaluate_text(file, "", sources, sink);
  ASSERT_TRUE(evaluation.scene) << render_text(sink, sources);
  ASSERT_EQ(evaluation.scene->shapes.size(), 12u);
  for (const Shape& shape : evaluation.scene->shapes) {
    const auto& [a, b, c] = std::get<Triangle>(shape.geometry).corners;
    EXPECT_GT(dot(cross(b - a, c - a), a + b + c), 0) << shape.name;
  }
}

// What a person reads off the file by the format's text is what the scene holds.
TEST(NffWrite, MaterialsAreTheNumbersOfTheFill) {
  const Read read(kView +
                  "f 0.1 0.2 0.3 0.4 0.5 6 0.7 1.8 s 0 0 0 1\n"
                  "f 0.1 0.2 0.3 0.4 0 6 0 1.8 s 0 0 0 1\n"
                  "f 0.1 0.2 0.3 0.4 0 6 0.7 0 s 0 0 0 1\n");
  ASSERT_TRUE(read.scene) << read.errors();
  SourceManager sources;
  DiagnosticSink sink;
  const FileId file = sources.add("a.scn", write_scn(*read.scene, "a.nff"));
  const auto evaluation = parser::evaluate_text(file, "", sources, sink);
  ASSERT_TRUE(evaluation.scene) << render_text(sink, sources);
  const Scene& scene = *evaluation.scene;
  ASSERT_EQ(scene.shapes.size(), 3u);
  const auto finish = [&](std::size_t shape) {
    return std::get<PovFinish>(scene.materials[scene.shapes[shape].material].scattering);
  };
  const PovFinish all = finish(0);
  EXPECT_EQ(all.ambient, Rgbd(0));
  EXPECT_EQ(all.diffuse, 0.4);
  EXPECT_EQ(all.phong, 0.5);
  EXPECT_EQ(all.phong_size, 6);
  EXPECT_EQ(all.reflection.min, Rgbd(0.5));
  EXPECT_EQ(all.reflection.max, Rgbd(0.5));
  EXPECT_EQ(all.transmit, 0.7);
  EXPECT_EQ(all.filter, 0);
  EXPECT_EQ(all.ior, 1.8);
  EXPECT_EQ(finish(1).phong, 0);
  EXPECT_EQ(finish(1).transmit, 0);
  EXPECT_EQ(finish(1).ior, 1);
  EXPECT_EQ(finish(2).transmit, 0.7);
  EXPECT_EQ(finish(2).ior, 1);
}

TEST(NffWrite, ANameCannotLeaveItsComment) {
  const Read read(kView);
  ASSERT_TRUE(read.scene) << read.errors();
  const std::string scn = write_scn(*read.scene, "a\nsphere {}\r\xff.nff");
  EXPECT_NE(scn.find("// a?sphere {}??.nff, in"), scn.npos) << scn;
}

}  // namespace
}  // namespace alhazen
