#include "lippmann/dataset/dataset.hpp"

#include <array>
#include <atomic>

#include "bindings.hpp"
#include "interruptible.hpp"

namespace lippmann::python {
namespace {

void set_dataset_views(DatasetParams& params, std::array<int, 2> rows_columns, std::array<int, 2> height_width) {
  params.grid = {rows_columns[1], rows_columns[0]};
  params.view_size = {height_width[1], height_width[0]};
}

DatasetReport make_dataset_in_python(const DatasetParams& params, int threads, const py::object& progress) {
  Interruptible work(threads);
  std::atomic<int> made{0};
  DatasetReport report;
  py::object progress_of_sample = py::none();
  if (!progress.is_none()) progress_of_sample = py::cpp_function([&](double share) { progress(made.load(), share); });
  work.run(progress_of_sample, [&](const Context& context) {
    DatasetObserver observer;
    observer.made = [&](int, double) {
      context.frame_progress(0.0);
      ++made;
    };
    report = make_dataset(params, context, observer);
  });
  return report;
}

}  // namespace

void bind_dataset(py::module_& module) {
  py::class_<DatasetParams>(module, "DatasetParams")
      .def(py::init<>())
      .def_readwrite("scenes", &DatasetParams::scenes)
      .def_readwrite("folder", &DatasetParams::folder)
      .def_readwrite("count", &DatasetParams::count)
      .def_readwrite("seed", &DatasetParams::seed)
      .def_readwrite("spp", &DatasetParams::spp)
      .def_readwrite("unit", &DatasetParams::unit)
      .def("set_views", &set_dataset_views);
  py::class_<DatasetReport>(module, "DatasetReport")
      .def_readonly("wanted", &DatasetReport::wanted)
      .def_readonly("kept", &DatasetReport::kept)
      .def_readonly("made", &DatasetReport::made)
      .def_readonly("remade", &DatasetReport::remade)
      .def_readonly("seconds", &DatasetReport::seconds)
      .def_readonly("bytes", &DatasetReport::bytes)
      .def_readonly("is_complete", &DatasetReport::is_complete);
  module.def("make_dataset", &make_dataset_in_python);
}

}  // namespace lippmann::python
