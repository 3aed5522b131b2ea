// SPDX-License-Identifier: MIT
#include "croquis/io/json_place.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "";
}

TEST(JsonPlace, EveryComplaintNamesThePlace) {
  const auto json = parse_json(R"({"nodes":[{"mesh":7,"name":3,"a/b~":"x"}]})");
  const JsonPlace node = JsonPlace(json.get(), "")["nodes"][0];
  EXPECT_EQ(error_of([&] { (void)node["mesh"].index(2, "mesh"); }),
            "/nodes/0/mesh: mesh 7 is not there: they run from 0 to 1");
  EXPECT_EQ(error_of([&] { (void)node["name"].text(); }), "/nodes/0/name: wanted a string");
  EXPECT_EQ(error_of([&] { (void)node["skin"].number(); }), "/nodes/0/skin: is missing");
  EXPECT_EQ(error_of([&] { (void)node["a/b~"].number(); }), "/nodes/0/a~1b~0: wanted a number");
}

TEST(JsonPlace, WhatIsNotThereIsEmpty) {
  const auto json = parse_json("{}");
  const JsonPlace root(json.get(), "");
  EXPECT_FALSE(root["a"]["b"].exists());
  EXPECT_EQ(root["a"].size(), 0);
  EXPECT_EQ(root["a"].index_or_none(1, "node"), -1);
  EXPECT_EQ(root["a"].text_or("none"), "none");
}

TEST(JsonPlace, FractionsAndHugeNumbersAreNoIndices) {
  const auto json = parse_json("[0.5, 1e300, -1, 2]");
  const JsonPlace root(json.get(), "");
  for (int i = 0; i < 3; ++i) EXPECT_NE(error_of([&] { (void)root[i].index(5, "node"); }), "") << i;
  EXPECT_EQ(root[3].index(5, "node"), 2);
}

TEST(JsonPlace, NestingAndMembersAreBounded) {
  EXPECT_NE(error_of([] { (void)parse_json(std::string(100000, '[')); }), "");
  std::string many = "{";
  for (int i = 0; i < 30000; ++i) many += "\"" + std::to_string(i) + "\":0,";
  EXPECT_NE(error_of([&] { (void)parse_json(many + "\"z\":0}"); }), "");
  EXPECT_NE(error_of([] { (void)parse_json("[1e999]"); }), "");
}

}  // namespace
}  // namespace croquis
