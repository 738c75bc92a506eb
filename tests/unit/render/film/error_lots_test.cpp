#include "render/film/error_lots.h"

#include <gtest/gtest.h>

namespace alhazen::render {
namespace {

using Found = std::optional<ErrorLots::Found>;
constexpr auto kNothing = [](std::size_t) { return Found(); };

// The 95 % upper limits of a Poisson mean when 0, 1, 4, 10 events were seen
// are 3.00, 4.74, 9.15, 16.96 (F. Garwood, Biometrika 28, 1936); Wilson's
// formula comes as near as 10 %.
TEST(UpperBound, CountsEvents) {
  const double limits[][2] = {{0, 3.00}, {1, 4.74}, {4, 9.15}, {10, 16.96}};
  for (const auto& [events, limit] : limits) {
    EXPECT_NEAR(upper_bound(events, events, 1), limit, 0.1 * limit) << events;
    EXPECT_NEAR(upper_bound(5 * events, 25 * events, 5), 5 * limit, 0.5 * limit) << events;
  }
  EXPECT_EQ(upper_bound(0, 0, 0), 0);
}

// Four are drawn of 100 that rest; each was believed to have a variance of 1.
TEST(ErrorLots, DrawnPixelsStandForThoseThatRest) {
  ErrorLots lots;
  for (std::size_t p = 0; p < 4; ++p)
    lots.draw(p, 1, 1);
  lots.evaluate(100, [](std::size_t p) { return p == 0 ? Found({5, 5}) : Found({1, 1}); });
  EXPECT_DOUBLE_EQ(lots.missed_loss(), 100);
  EXPECT_DOUBLE_EQ(lots.loss_noise(), 100 * 100);
  EXPECT_DOUBLE_EQ(lots.missed_variance(),
                   1 + 1);  // the mean, and its standard error
}

TEST(ErrorLots, WhatWasNotDoneTellsNothing) {
  ErrorLots lots;
  lots.draw(3, 1, 1);
  lots.evaluate(100, kNothing);
  EXPECT_EQ(lots.missed_loss(), 0);
}

TEST(ErrorLots, WhatIsLikeTheChosenIsForgotten) {
  ErrorLots lots;
  lots.add_drawn({1, 0, 0});
  lots.add_drawn({8, 6, 6});
  lots.forget([](double seemed) { return seemed > 4; });
  lots.evaluate(100, kNothing);
  EXPECT_EQ(lots.missed_loss(), 0);
}

// Fifty drawn pixels of 400 have seen nothing: three events of eight pixels
// each may be hidden.
TEST(ErrorLots, ExchangedPixelsTellWhatLotsAreTooFewFor) {
  const auto missed = [](int exchanged, int seen_by_lot) {
    ErrorLots lots;
    for (int k = 0; k < 50; ++k)
      lots.add_drawn({0, k < seen_by_lot ? 1.0 : 0.0, 0});
    for (int k = 0; k < exchanged; ++k)
      lots.add_exchanged({0, 1, 1});
    lots.evaluate(400, kNothing);
    return lots.missed_loss();
  };
  EXPECT_EQ(missed(10, 0), 10);
  EXPECT_DOUBLE_EQ(missed(1000, 0), upper_bound(0, 0, 8));
  EXPECT_EQ(missed(10, 2), 16);     // the lots say more
  EXPECT_EQ(missed(1000, 10), 80);  // the lots know
}

// Without lots there is nothing that speaks against what the exchanged pixels say.
TEST(ErrorLots, WithoutLotsExchangedPixelsAreBelieved) {
  ErrorLots lots;
  for (int k = 0; k < 3; ++k)
    lots.add_exchanged({0, 1, 1});
  lots.evaluate(4, kNothing);
  EXPECT_EQ(lots.missed_loss(), 3);
}

}  // namespace
}  // namespace alhazen::render
