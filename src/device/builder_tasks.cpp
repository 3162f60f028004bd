#include "device/builder_tasks.hpp"

#include "core/task_order.hpp"

namespace lippmann {
namespace {

TaskOrder& order() {
  static TaskOrder order;
  return order;
}

}  // namespace

void commit_scene(const EmbreeScene& scene) {
  order().all_begin();
  rtcCommitScene(scene.get());
  order().all_ended();
}

BuilderCall::BuilderCall() { order().begin(); }
BuilderCall::~BuilderCall() { order().end(); }

}  // namespace lippmann
