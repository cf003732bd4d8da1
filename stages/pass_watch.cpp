#include "stages/pass_watch.h"

namespace sturm {

bool PassWatch::operator()(const PassReport& report) {
  const double now = total_.seconds(), pass_seconds = now - passes_end_;
  if (preview_.show && (!last_shown_ || now - *last_shown_ >= preview_.interval_s)) {
    preview_.show(report.picture_so_far());
    last_shown_ = total_.seconds();
  }
  passes_end_ = total_.seconds();
  return !budget_s_ || passes_end_ + pass_seconds <= *budget_s_;  // the next pass takes about as long as the last
}

}  // namespace sturm
