#include "app/compare/layer.h"

#include <gmock/gmock.h>

namespace alhazen {
namespace {

using testing::ElementsAre;
using Names = std::vector<std::string>;

TEST(Layer, IsWhatStandsBeforeTheLastDot) {
  EXPECT_EQ(layer_of("N.X"), "N");
  EXPECT_EQ(layer_of("left.albedo.R"), "left.albedo");
  EXPECT_EQ(layer_of("G"), "RGB");
  EXPECT_EQ(layer_of("A"), "A");
  EXPECT_EQ(layer_of("Z"), "Z");
}

TEST(Layer, ColoursAreFoundInAnyOrder) {
  EXPECT_EQ(colors_of(Names{"B", "G", "R"}), (std::array<std::size_t, 3>{2, 1, 0}));
  EXPECT_EQ(colors_of(Names{"albedo.R", "albedo.A", "albedo.B", "albedo.G"}),
            (std::array<std::size_t, 3>{0, 3, 2}));
  EXPECT_EQ(colors_of(Names{"R", "G"}), std::nullopt);
  EXPECT_EQ(colors_of(Names{"N.X", "N.Y", "N.Z"}), std::nullopt);
}

TEST(Layer, CryptomatteHasIdsAndNoColours) {
  EXPECT_EQ(colors_of(Names{"CryptoObject00.R", "CryptoObject00.G", "CryptoObject00.B"}),
            std::nullopt);
  EXPECT_TRUE(holds_ids("CryptoObject00.r"));
  EXPECT_TRUE(holds_ids("CryptoMaterial02.b"));
  EXPECT_FALSE(holds_ids("CryptoObject00.g"));
  EXPECT_FALSE(holds_ids("albedo.r"));
}

TEST(Layer, ChannelsAreToldInTheOrderOfReading) {
  Names names{"A", "B", "G", "N.X", "N.Y", "R", "Z", "albedo.B", "albedo.G", "albedo.R"};
  sort_for_reading(names);
  EXPECT_THAT(names, ElementsAre("R", "G", "B", "A", "N.X", "N.Y", "Z", "albedo.R", "albedo.G",
                                 "albedo.B"));
}

}  // namespace
}  // namespace alhazen
