#include "recorder.hpp"

#include <utility>

namespace isostretch::baselines {

Recorder::Recorder(const Instance& instance, const Options& options, const PointCallback& callback)
    : instance_(instance), options_(options), callback_(callback), phase_(&result_.seconds.modelling) {
  result_.message.clear();
}

void Recorder::book_time() {
  *phase_ += timer_.seconds();
  timer_ = Timer();
}

void Recorder::begin(Phase phase) {
  book_time();
  switch (phase) {
    case Phase::modelling:
      phase_ = &result_.seconds.modelling;
      break;
    case Phase::solving:
      phase_ = &result_.seconds.solving;
      break;
    case Phase::reading:
      phase_ = &result_.seconds.reading;
      break;
  }
}

bool Recorder::record(const Vector& x) {
  return record(x, points());
}

bool Recorder::record(const Vector& x, int iteration) {
  book_time();
  const Point point{iteration, result_.seconds.total(), measure(instance_.problem, x)};
  result_.trace.push_back(point);
  if (callback_ && callback_(point, x) == CallbackAction::stop)
    end(Status::callback, "stopped by the callback");
  if (stops_without_inversions_ && point.measures.inverted == 0)
    end(Status::converged, "no element is inverted");
  timer_ = Timer();
  return may_go_on();
}

bool Recorder::may_go_on() {
  if (options_.stop.deadline_passed()) end(Status::time_limit, "the time limit is reached");
  if (options_.stop.stop_requested()) end(Status::callback, "stopped by the caller");
  return !ended();
}

void Recorder::end(Status status, std::string message) {
  if (ended()) return;
  result_.status = status;
  result_.message = std::move(message);
}

Result Recorder::finish(const Vector& x) {
  book_time();
  if (x.size() > 0) {
    result_.x = x;
    result_.measures = measure(instance_.problem, x);
  }
  if (!ended()) end(Status::failed, "the solver did not say how it ended");
  return std::move(result_);
}

}  // namespace isostretch::baselines
