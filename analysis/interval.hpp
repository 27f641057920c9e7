#pragma once

namespace brouwer {

struct Interval {
  double low = 0, high = 0;
};

}  // namespace brouwer
