/* Reads one file with the VTK library (9.1), and hands over columns and triangles. A grid in three
 * dimensions is cut by a plane across the axis that goes neither along the tank nor upwards; values
 * of cells become values of points, by the mean over the cells that meet there. */
#include "import/vtk_library.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkCleanPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkCutter.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkHDFReader.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkLogger.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLGenericDataObjectReader.h>

namespace {

struct failure {
  std::string what;
};

/* The first error that readers told of, and in legacy files the first warning too: their readers go
 * on with zeros where a file ends early, and warn of it. */
struct complaints {
  const bool legacy;
  std::string first;
  explicit complaints(bool of_legacy);
  ~complaints() {
    vtkLogger::RemoveCallback("plunge");
  }
};

void hear(void *data, const vtkLogger::Message &message) {
  auto *heard = (complaints *)data;
  const bool counts = heard->legacy || message.verbosity <= vtkLogger::VERBOSITY_ERROR;
  if (!counts || !heard->first.empty()) return;
  const std::string text = message.message; // of an error "CLASS (ADDRESS): SENTENCE"
  const size_t stop = text.find("): "), begin = stop == std::string::npos ? 0 : stop + 3;
  heard->first = text.substr(begin, text.find('\n', begin) - begin).substr(0, 200);
}

complaints::complaints(bool of_legacy) : legacy(of_legacy) {
  vtkLogger::AddCallback("plunge", hear, this, vtkLogger::VERBOSITY_WARNING);
}

bool ends_with(const std::string &s, const char *end) {
  const size_t n = std::strlen(end);
  return s.size() >= n && s.compare(s.size() - n, n, end) == 0;
}

bool is_foam(const std::string &path) {
  return ends_with(path, ".foam") || ends_with(path, "controlDict");
}

vtkSmartPointer<vtkOpenFOAMReader> foam(const char *path) {
  auto reader = vtkSmartPointer<vtkOpenFOAMReader>::New();
  reader->SetFileName(path);
  reader->SkipZeroTimeOff();
  reader->UpdateInformation();
  return reader;
}

vtkSmartPointer<vtkDataObject> read_foam(const struct import_ask *ask) {
  auto reader = foam(ask->path);
  vtkDoubleArray *times = reader->GetTimeValues();
  if (!times || (vtkIdType)ask->step >= times->GetNumberOfTuples())
    throw failure{"has no such time"};
  reader->UpdateTimeStep(times->GetValue((vtkIdType)ask->step));
  return vtkSmartPointer<vtkDataObject>(reader->GetOutput());
}

vtkSmartPointer<vtkDataObject> read_file(const struct import_ask *ask) {
  const std::string path = ask->path;
  if (is_foam(path)) return read_foam(ask);
  if (ends_with(path, ".vtkhdf") || ends_with(path, ".hdf")) {
    vtkNew<vtkHDFReader> reader;
    if (!reader->CanReadFile(ask->path)) throw failure{"is no VTKHDF file that the library reads"};
    reader->SetFileName(ask->path);
    reader->Update();
    return reader->GetOutputAsDataSet();
  }
  if (ends_with(path, ".vtk")) {
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(ask->path);
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllTensorsOn();
    reader->Update();
    return reader->GetOutput();
  }
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  bool parallel;
  if (reader->ReadOutputType(ask->path, parallel) < 0)
    throw failure{"is no file of VTK: allowed are .vtk, .vtu, .vtp, .vti, .vts, .vtr, .vtm and "
                  "parallel ones, .vtkhdf, .hdf, .foam"};
  reader->SetFileName(ask->path);
  reader->Update();
  return reader->GetOutput();
}

/* The array asks for points as well: as a column. */
bool is_points(const char *name) {
  return !std::strcmp(name, "Points");
}

vtkDataArray *find_array(vtkFieldData *data, const char *name) {
  return data ? data->GetArray(name) : nullptr;
}

/* Blocks that have what is asked for become one grid; a mere boundary of an OpenFOAM case has not,
 * or is no volume. */
vtkSmartPointer<vtkDataSet> one_grid(vtkDataObject *data) {
  if (auto *set = vtkDataSet::SafeDownCast(data)) return set;
  auto *blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks) throw failure{"holds no grid and no points"};
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOn();
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(blocks->NewIterator());
  int n = 0, most = 0;
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    if (auto *set = vtkDataSet::SafeDownCast(at->GetCurrentDataObject()))
      if (set->GetNumberOfCells() > 0) most = std::max(most, set->GetCell(0)->GetCellDimension());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    if (auto *set = vtkDataSet::SafeDownCast(at->GetCurrentDataObject()))
      if (set->GetNumberOfCells() > 0 && set->GetCell(0)->GetCellDimension() == most) {
        append->AddInputData(set);
        n++;
      }
  if (!n) throw failure{"holds no grid and no points"};
  append->Update();
  return append->GetOutput();
}

std::string names_of(vtkDataSet *set) {
  std::string list;
  for (vtkFieldData *data :
       {(vtkFieldData *)set->GetPointData(), (vtkFieldData *)set->GetCellData()})
    for (int k = 0; k < data->GetNumberOfArrays(); k++)
      if (const char *name = data->GetArrayName(k)) {
        const std::string one = name;
        if (list.size() + one.size() < 200 &&
            (", " + list + ",").find(", " + one + ",") == std::string::npos)
          list += (list.empty() ? "" : ", ") + one;
      }
  return list.empty() ? "none" : list;
}

void no_array(vtkDataSet *set, const char *name, const char *also) {
  throw failure{"has no array '" + std::string(name) + "'; it has " + also + names_of(set)};
}

int pick(const char *column, int components) {
  char wrong[IMPORT_WRONG];
  size_t k;
  if (!import_pick(column, (size_t)components, &k, wrong)) throw failure{wrong};
  return (int)k;
}

/* ---- grids ---- */

/* With the asked for scalar on its points. */
vtkSmartPointer<vtkDataSet> with_point_data(vtkDataSet *set, const char *name) {
  if (find_array(set->GetPointData(), name)) return set;
  if (!find_array(set->GetCellData(), name)) no_array(set, name, "");
  vtkNew<vtkCellDataToPointData> mean;
  mean->SetInputData(set);
  mean->Update();
  return vtkDataSet::SafeDownCast(mean->GetOutput());
}

failure wrong_slice(double low, double high, double at) {
  char text[160];
  if (low == high)
    std::snprintf(text, sizeof text, "is flat, at %g across the tank; slice is at %g", low, at);
  else
    std::snprintf(text, sizeof text, "goes from %g to %g across the tank; slice is at %g", low,
                  high, at);
  return failure{text};
}

/* The triangles of a plane through it. A flat grid is that plane, its place maybe a float. */
vtkSmartPointer<vtkPolyData> plane_of(vtkDataSet *set, const struct import_ask *ask) {
  double box[6];
  const int across = 3 - ask->along - ask->up;
  set->GetBounds(box);
  const double low = box[2 * across], high = box[2 * across + 1];
  vtkSmartPointer<vtkPolyData> flat;
  double size = 0;
  for (const double side : box) size = std::max(size, std::fabs(side));
  if (high == low && std::fabs(ask->slice - low) > FLT_EPSILON * size) // false without a slice
    throw wrong_slice(low, high, ask->slice);
  if (high > low) {
    const double at = std::isnan(ask->slice) ? (low + high) / 2 : ask->slice;
    if (!(at >= low && at <= high)) throw wrong_slice(low, high, at);
    double normal[3] = {0, 0, 0}, origin[3] = {0, 0, 0};
    normal[across] = 1;
    origin[across] = at;
    vtkNew<vtkPlane> plane;
    plane->SetNormal(normal);
    plane->SetOrigin(origin);
    vtkNew<vtkCutter> cutter;
    cutter->SetCutFunction(plane);
    cutter->GenerateTrianglesOff();
    cutter->SetInputData(set);
    cutter->Update();
    flat = cutter->GetOutput();
  } else {
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(set);
    vtkNew<vtkCleanPolyData> clean; // pieces of a parallel file share the points between them
    clean->SetInputConnection(surface->GetOutputPort());
    clean->SetTolerance(0);
    clean->Update();
    flat = clean->GetOutput();
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(flat);
  triangles->Update();
  return triangles->GetOutput();
}

double *column(size_t n) {
  auto *values = (double *)std::malloc((n + 1) * sizeof(double));
  if (!values) throw failure{"needs more memory than there is"};
  return values;
}

void read_grid(vtkDataSet *set, const struct import_ask *ask, struct import_table *t) {
  char name[IMPORT_LONGEST + 1];
  import_array_name(ask->names[IMPORT_field], name);
  auto with = with_point_data(set, name);
  auto flat = plane_of(with, ask);
  vtkDataArray *field = find_array(flat->GetPointData(), name);
  const vtkIdType n = flat->GetNumberOfPoints();
  if (!field || n == 0) throw failure{"has no cells in that plane"};
  const int component = pick(ask->names[IMPORT_field], field->GetNumberOfComponents());
  t->n = (size_t)n;
  t->column[IMPORT_x] = column(t->n);
  t->column[IMPORT_y] = column(t->n);
  t->column[IMPORT_field] = column(t->n);
  for (vtkIdType i = 0; i < n; i++) {
    double p[3];
    flat->GetPoint(i, p);
    t->column[IMPORT_x][i] = p[ask->along];
    t->column[IMPORT_y][i] = p[ask->up];
    t->column[IMPORT_field][i] = field->GetComponent(i, component);
  }
  const vtkIdType cells = flat->GetNumberOfCells();
  t->mesh.corner = (size_t *)std::malloc((size_t)(3 * cells + 1) * sizeof(size_t));
  if (!t->mesh.corner) throw failure{"needs more memory than there is"};
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells; c++) {
    flat->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() != 3) continue;
    for (int k = 0; k < 3; k++) t->mesh.corner[3 * t->mesh.n + (size_t)k] = (size_t)ids->GetId(k);
    t->mesh.n++;
  }
}

/* ---- points ---- */

void read_points(vtkDataSet *set, const struct import_ask *ask, struct import_table *t) {
  t->n = (size_t)set->GetNumberOfPoints();
  for (int k = 0; k < IMPORT_N_ROLES; k++) {
    if (!ask->names[k]) continue;
    char name[IMPORT_LONGEST + 1];
    import_array_name(ask->names[k], name);
    vtkDataArray *array = find_array(set->GetPointData(), name);
    const bool points = !array && is_points(name);
    if (!array && !points) no_array(set, name, "Points, ");
    const int component = pick(ask->names[k], points ? 3 : array->GetNumberOfComponents());
    t->column[k] = column(t->n);
    for (size_t i = 0; i < t->n; i++)
      t->column[k][i] = points ? set->GetPoint((vtkIdType)i)[component]
                               : array->GetComponent((vtkIdType)i, component);
  }
}

void read_time(vtkDataObject *data, const struct import_ask *ask, struct import_table *t) {
  if (!ask->time_after) return;
  vtkDataArray *time = find_array(data->GetFieldData(), ask->time_after);
  if (!time || time->GetNumberOfValues() < 1)
    throw failure{"has no number '" + std::string(ask->time_after) + "' in its field data"};
  t->time = time->GetComponent(0, 0);
}

template <class work> int guarded(char message[IMPORT_VTK_MESSAGE], work &&do_it) {
  try {
    do_it();
    return 0;
  } catch (const failure &f) {
    std::snprintf(message, IMPORT_VTK_MESSAGE, "%s", f.what.c_str());
  } catch (const std::exception &e) {
    std::snprintf(message, IMPORT_VTK_MESSAGE, "cannot be read by VTK: %s", e.what());
  }
  return 1;
}

} // namespace

int import_vtk_library_steps(const struct import_ask *ask, size_t *n, double **times,
                             char message[IMPORT_VTK_MESSAGE]) {
  return guarded(message, [&] {
    *n = 1;
    if (!is_foam(ask->path)) {
      *times = column(1);
      **times = NAN;
      return;
    }
    auto reader = foam(ask->path);
    vtkDoubleArray *values = reader->GetTimeValues();
    *n = values ? (size_t)values->GetNumberOfTuples() : 0;
    if (*n == 0) throw failure{"is no OpenFOAM case with results"};
    *times = column(*n);
    for (size_t i = 0; i < *n; i++) (*times)[i] = values->GetValue((vtkIdType)i);
  });
}

int import_vtk_library_read(const struct import_ask *ask, struct import_table *t,
                            char message[IMPORT_VTK_MESSAGE]) {
  return guarded(message, [&] {
    complaints heard(ends_with(ask->path, ".vtk"));
    auto data = read_file(ask);
    if (!heard.first.empty()) throw failure{"is damaged or cut short (VTK: " + heard.first + ")"};
    if (!data) throw failure{"cannot be read by VTK"};
    read_time(data, ask, t);
    auto set = one_grid(data);
    if (set->GetNumberOfPoints() == 0) throw failure{"has no points, or is damaged"};
    if (ask->grid)
      read_grid(set, ask, t);
    else
      read_points(set, ask, t);
  });
}
