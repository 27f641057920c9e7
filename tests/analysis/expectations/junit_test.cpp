// What a continuous-integration system reads.
#include "analysis/expectations/junit.hpp"

#include <gmock/gmock.h>

namespace brouwer {
namespace {

using testing::HasSubstr;

TEST(Junit, CountsAndNamesEachOutcome) {
  auto const xml =
      to_junit("elliptic-drift", {{true, "energy: no drift", "β = 0"}, {false, "casimir: no drift", "β = 1"}});
  EXPECT_THAT(xml, testing::StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"elliptic-drift\" tests=\"2\" failures=\"1\" errors=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("name=\"energy: no drift\"><system-out>β = 0</system-out>"));
  EXPECT_THAT(xml, HasSubstr("name=\"casimir: no drift\"><failure message=\"β = 1\">"));
}

TEST(Junit, EscapesWhatXmlWouldMisread) {
  auto const xml = to_junit("a<b>&\"c\"", {{false, "p < 1e-3 & 'q'", "]]>\x1b"}});
  EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b&gt;&amp;&quot;c&quot;\""));
  EXPECT_THAT(xml, HasSubstr("name=\"p &lt; 1e-3 &amp; &#39;q&#39;\""));
  EXPECT_THAT(xml, HasSubstr("]]&gt;\xEF\xBF\xBD"));
}

TEST(Junit, OfNothingIsAnEmptySuite) { EXPECT_THAT(to_junit("none", {}), HasSubstr("tests=\"0\" failures=\"0\"")); }

}  // namespace
}  // namespace brouwer
