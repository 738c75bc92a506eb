#include "render/image/cryptomatte.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alhazen::render {
namespace {

// The vectors of the specification, "Test vectors" and "ID generation".
TEST(Cryptomatte, HashesOfTheSpecification) {
  EXPECT_EQ(cryptomatte_hash("bunny"), 0x13851a76u);
  EXPECT_EQ(cryptomatte_hash("default"), 0x42c9679fu);
}

TEST(Cryptomatte, KeysAreTheFirstSevenDigitsOfTheHash) {
  EXPECT_EQ(cryptomatte_key("CryptoObject"), "3ae39a5");
  EXPECT_EQ(cryptomatte_key("CryptoMaterial"), "be359d6");
  EXPECT_EQ(cryptomatte_key("CryptoAsset"), "f42029d");
}

TEST(Cryptomatte, NoIdIsDenormalInfiniteOrNan) {
  // One name in 128 needs its exponent mended: 10,000 names meet both cases many times.
  for (int i = 0; i < 10000; ++i) {
    const float id = std::bit_cast<float>(cryptomatte_hash("object" + std::to_string(i)));
    EXPECT_TRUE(std::isnormal(id)) << i;
  }
}

TEST(Cryptomatte, RanksAreSortedByCoverageThenHash) {
  CryptomatteLayer layer("CryptoObject", 2, 1, 3, {"a", "b"});
  EXPECT_EQ(layer.channels().names(),
            (std::vector<std::string>{"CryptoObject00.r", "CryptoObject00.g", "CryptoObject00.b",
                                      "CryptoObject00.a", "CryptoObject01.r", "CryptoObject01.g",
                                      "CryptoObject01.b", "CryptoObject01.a"}));
  layer.set_pixel(1, 0, {{7, 0.125F}, {9, 0.25F}, {5, 0.5F}, {3, 0.25F}, {11, 0.0625F}});
  const auto hash = [&](std::size_t rank) {
    return std::bit_cast<std::uint32_t>(layer.channels().at(2 * rank, 1, 0));
  };
  const auto coverage = [&](std::size_t rank) { return layer.channels().at(2 * rank + 1, 1, 0); };
  EXPECT_EQ((std::vector{hash(0), hash(1), hash(2), hash(3)}), (std::vector{5u, 3u, 9u, 7u}));
  EXPECT_EQ((std::vector{coverage(0), coverage(1), coverage(2), coverage(3)}),
            (std::vector{0.5F, 0.25F, 0.25F, 0.125F}));
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(layer.channels().at(i, 0, 0), 0.0F);
}

TEST(Cryptomatte, ManifestIsJsonThatGivesBackNamesAndHashes) {
  const CryptomatteLayer layer("CryptoObject", 1, 1, 2,
                               {"default", "with \"quotes\"", "bunny", "not UTF-8: \xff"});
  const auto manifest = nlohmann::json::parse(layer.manifest());
  EXPECT_EQ(manifest.size(), 4u);
  EXPECT_EQ(manifest.at("bunny"), "13851a76");
  EXPECT_EQ(manifest.at("default"), "42c9679f");
  EXPECT_TRUE(manifest.contains("with \"quotes\""));
  // Sorted by name, so that the order in which a scene makes objects does not change the file.
  EXPECT_LT(layer.manifest().find("bunny"), layer.manifest().find("default"));
}

}  // namespace
}  // namespace alhazen::render
