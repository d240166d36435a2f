#include "results/report.hpp"

#include <gtest/gtest.h>

#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "results/paint.hpp"
#include "sensors/scan.hpp"
#include "tests/results/run_sample.hpp"
#include "tests/results/samples.hpp"
#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

/// A run of two rooms, of which one has all its files.
fs::path make_run(const std::string& name) {
  const fs::path run = samples::scratch(name);
  write_json(run / "summary.json", samples::run_summary(9, 1));
  make_folder(run / "00000");
  Scan scan;
  scan.cloud.points = {{0, 0, 0.72}, {0.1, 0, 0.72}, {0, 0, 1.1}, {3, 3, 0}};
  scan.truth.resize(4);
  scan.line.assign(4, 0);
  scan.beam.assign(4, 0);
  write_cloud(run / "00000" / "scan.pcd", cloud_with_truth(scan));
  write_surfaces(run / "00000" / "surfaces.json", samples::two_surfaces());
  write_json(run / "00000" / "labels.json", labelling_to_json(samples::two_labels(), {2, 1}));
  write_png(run / "00000" / "labels.png", blank_image(840, 480, {10, 200, 30}));
  return run;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

TEST(Report, IsOneFileThatNeedsNothingElse) {
  const fs::path run = make_run("report");
  write_report(run, run / "report.html");
  const std::string html = read_file(run / "report.html");
  EXPECT_EQ(html.rfind("<!doctype html>", 0), 0u);
  EXPECT_NE(html.find("Of 12 things in 2 rooms, 9 were found"), std::string::npos);
  EXPECT_EQ(count(html, "id=\"scene-0\""), 1u);
  EXPECT_EQ(count(html, "id=\"scene-1\""), 0u);  // its files are not there
  EXPECT_EQ(count(html, "data:image/png;base64,"), 1u);
  // Nothing is fetched: no address in a src, href or import.
  for (const char* loads : {"<script src", "<link", "@import", "src=\"http"})
    EXPECT_EQ(count(html, loads), 0u) << loads;
  EXPECT_EQ(count(html, "<script"), count(html, "</script>"));
}

TEST(Report, SameRunSameBytes) {
  const fs::path run = make_run("report_bytes");
  write_report(run, run / "a.html");
  write_report(run, run / "b.html");
  EXPECT_EQ(read_file(run / "a.html"), read_file(run / "b.html"));
}

TEST(Report, AHostileNameStaysText) {
  const fs::path run = make_run("report_hostile");
  ReportOptions options;
  options.title = "</script><script>alert(1)</script>";
  write_report(run, run / "report.html", options);
  EXPECT_EQ(count(read_file(run / "report.html"), "<script>alert"), 0u);
}

TEST(Report, ADamagedRoomDoesNotTakeTheOthersAway) {
  const fs::path run = make_run("report_damaged");
  make_folder(run / "00001");
  for (const char* file : {"scan.pcd", "surfaces.json", "labels.json"}) {
    fs::copy_file(run / "00000" / file, run / "00001" / file, fs::copy_options::overwrite_existing);
  }
  write_file(run / "00001" / "surfaces.json", "{");
  write_report(run, run / "report.html");
  const std::string html = read_file(run / "report.html");
  EXPECT_EQ(count(html, "id=\"scene-0\""), 1u);
  EXPECT_EQ(count(html, "id=\"scene-1\""), 0u);
  EXPECT_EQ(count(html, "\"problem\":"), 1u);
}

TEST(Report, WhatIsMissingIsNamed) {
  const fs::path empty = samples::scratch("report_empty");
  try {
    write_report(empty, empty / "report.html");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("summary.json"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(empty / "report.html"));
  const fs::path run = make_run("report_unwritable");
  write_file(run / "file", "");
  EXPECT_THROW(write_report(run, run / "file" / "report.html"), Error);
}

}  // namespace
}  // namespace scanchor
