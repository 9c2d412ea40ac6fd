// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/surface/reconstruction.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "filmsticking/status.h"
#include "filmsticking/types.h"

namespace filmsticking {
struct Execution;
struct Result;
}  // namespace filmsticking

namespace pcl {

/** \brief Closed, manifold surface through the points of a cloud without normals (Filmsticking++).
 *
 * Every vertex of the result is a point of the input, copied with all its fields; getVertexIndices() says
 * which. The surface is closed, 2-manifold and wound counter-clockwise seen from outside. Points with a
 * coordinate that is not finite, repeated points and outliers (setKeepOutliers()) are left out. Normals are
 * copied like any other field and not read. No parameter has to be set:
 *
 * \code
 * pcl::FilmstickingPP<pcl::PointXYZ> filmsticking;
 * filmsticking.setInputCloud(cloud);
 * pcl::PolygonMesh mesh;
 * filmsticking.reconstruct(mesh);
 * if (filmsticking.getStatus() != filmsticking::Status::Ok) { ... }  // the mesh is empty then
 * \endcode
 *
 * reconstruct() never throws: it answers any input with a mesh, or with an empty one, a status and one
 * line of PCL_ERROR. Fewer than four distinct points, and points on one line or plane, enclose nothing and
 * are refused. The same input gives the same mesh for any number of threads, in a new object as in one that
 * was used before, and different objects may run in different threads at once. The method needs no
 * neighbour search of the input: a search method, if one is set, is kept and not used.
 *
 * In place of pcl::GreedyProjectionTriangulation or pcl::Poisson, through pcl::PCLSurfaceBase, only the
 * constructor changes. Unlike the former's, the mesh has a cloud of its vertices only.
 *
 * Method: Wang et al., "Filmsticking++", arXiv 2602.11433. For a point type of your own, define
 * PCL_NO_PRECOMPILE before the first include, or include pcl/surface/impl/filmsticking_pp.hpp.
 *
 * \ingroup surface
 */
template <typename PointInT>
class FilmstickingPP : public SurfaceReconstruction<PointInT> {
 public:
  using Ptr = shared_ptr<FilmstickingPP<PointInT>>;             ///< Shared pointer to an object.
  using ConstPtr = shared_ptr<const FilmstickingPP<PointInT>>;  ///< Shared pointer to a constant object.

  using PointCloud = pcl::PointCloud<PointInT>;              ///< The input's type.
  using PointCloudPtr = typename PointCloud::Ptr;            ///< Shared pointer to a cloud.
  using PointCloudConstPtr = typename PointCloud::ConstPtr;  ///< Shared pointer to a constant cloud.
  using PointIndicesConstPtr = pcl::PointIndices::ConstPtr;  ///< Shared pointer to constant indices.

  using Method = filmsticking::Method;                  ///< What makes the surface.
  using FilmStart = filmsticking::FilmStart;            ///< Where a film starts.
  using InitialSurface = filmsticking::InitialSurface;  ///< The former name of both; goes with version 0.3.
  using FieldMethod = filmsticking::FieldMethod;        ///< What corrects the film's topology.
  using RingChoice = filmsticking::RingChoice;          ///< Which region of several a site keeps.
  using Options = filmsticking::Options;                ///< All that can be chosen.
  using Status = filmsticking::Status;                  ///< How a reconstruction ended.
  using Report = filmsticking::Report;                  ///< What a reconstruction did.

  /** \brief Told the share done, from 0 to 1, and the part of the method at work. */
  using ProgressCallback = std::function<void(double share, const char* room)>;

  /** \brief Receives the film after a step (0: the initial surface), in the input's coordinates. */
  using StepCallback = std::function<void(int step, const filmsticking::Mesh& film)>;

  using SurfaceReconstruction<PointInT>::input_;
  using SurfaceReconstruction<PointInT>::indices_;

  /** \brief Constructor: the defaults of filmsticking::Options. */
  FilmstickingPP() { check_tree_ = false; }

  /** \brief Destructor. */
  ~FilmstickingPP() override = default;

  /** \brief Set the input cloud; one set by setInputBlob() is forgotten.
   * \param[in] cloud the points, with or without normals, organized or not, dense or not
   */
  void setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Set the input as a blob, to keep fields that \a PointInT does not have.
   *
   * reconstruct(pcl::PolygonMesh&) then copies the bytes of every vertex and the layout of the fields from
   * the blob; the other reconstruct() converts the vertices as pcl::fromPCLPointCloud2() does. The blob is
   * read where it lies and must not change meanwhile; getInputCloud() is null.
   * \param[in] blob points with fields x, y and z, all FLOAT32 or all FLOAT64; another kind is refused by
   * reconstruct(). FLOAT64 is read with all its digits
   */
  void setInputBlob(const pcl::PCLPointCloud2::ConstPtr& blob);

  /** \brief Get the input set by setInputBlob(); null if the input was set otherwise. */
  pcl::PCLPointCloud2::ConstPtr getInputBlob() const { return blob_; }

  /** \brief Set the points to use; null stands for all points. */
  void setIndices(const pcl::IndicesPtr& indices) override;

  /** \brief Set the points to use; null stands for all points. The indices are copied. */
  void setIndices(const pcl::IndicesConstPtr& indices) override;

  /** \brief Set the points to use; null stands for all points. The indices are copied. */
  void setIndices(const PointIndicesConstPtr& indices) override;

  /** \brief Use a window of an organized cloud. A window that is not in the cloud is refused by
   * reconstruct(). The input cloud has to be set before.
   * \param[in] row_start first row
   * \param[in] col_start first column
   * \param[in] nb_rows number of rows
   * \param[in] nb_cols number of columns
   */
  void setIndices(std::size_t row_start, std::size_t col_start, std::size_t nb_rows,
                  std::size_t nb_cols) override;

  /** \brief Reconstruct the surface through the points given by setInputCloud() and setIndices().
   * \param[out] output the triangles, and a cloud with their vertices only, unorganized and dense; empty on
   * failure. The headers are the input's.
   */
  void reconstruct(pcl::PolygonMesh& output) override;

  /** \brief Reconstruct the surface through the points given by setInputCloud() and setIndices().
   * \param[out] points the vertices with all their fields, unorganized and dense; empty on failure
   * \param[out] polygons the triangles, as indices into \a points; empty on failure
   */
  void reconstruct(pcl::PointCloud<PointInT>& points, std::vector<pcl::Vertices>& polygons) override;

  /** \brief Reconstruct the surface through the points given by setInputCloud() or setInputBlob(), and
   * setIndices(). As reconstruct(pcl::PolygonMesh&), without a heap block for every triangle.
   * \param[out] vertices the vertices with all their fields, unorganized and dense; empty on failure
   * \param[out] triangles indices into \a vertices; empty on failure
   */
  void reconstruct(pcl::PCLPointCloud2& vertices, std::vector<filmsticking::Triangle>& triangles);

  /** \brief Stop the reconstruction that is running, from any thread: it ends soon with Status::Cancelled.
   * Without a running reconstruction it does nothing. See setCancelFlag().
   */
  void cancel() { cancel_.raised = true; }

  /** \brief Listen to a flag of the caller's in place of cancel(), as a signal handler may set it.
   * \param[in] flag must outlive the reconstruction; null stands for cancel()
   */
  void setCancelFlag(const std::atomic<bool>* flag) { cancel_flag_ = flag; }

  /** \brief How the last reconstruct() ended; InternalError before the first. */
  Status getStatus() const { return status_; }

  /** \brief One sentence about the failure of the last reconstruct(); empty when it succeeded. */
  const std::string& getStatusMessage() const { return status_message_; }

  /** \brief What the last reconstruct() did, as far as it got. */
  const Report& getReport() const { return report_; }

  /** \brief The input point of each output vertex.
   * \return for vertex k its index in the input cloud (also when setIndices() was used); empty on failure
   */
  const pcl::Indices& getVertexIndices() const { return vertex_indices_; }

  /** \brief Set what makes the surface: labelled tetrahedra (the default), or the paper's film. */
  void setMethod(Method method) {
    options_.method = method;
    options_.initial_surface = InitialSurface::Carve;
  }

  /** \brief Get what makes the surface. */
  Method getMethod() const { return filmsticking::method_of(options_); }

  /** \brief Set the surface that a film starts from, and Method::Film with it. */
  void setFilmStart(FilmStart start) {
    setMethod(Method::Film);
    options_.film_start = start;
  }

  /** \brief Get the surface that a film starts from. */
  FilmStart getFilmStart() const { return filmsticking::film_start_of(options_); }

  /** \brief Former name of setMethod() and setFilmStart(). */
  [[deprecated("use setMethod() or setFilmStart()")]] void setInitialSurface(InitialSurface initial_surface) {
    options_.initial_surface = initial_surface;
  }

  /** \brief Former name of getMethod() and getFilmStart(). */
  [[deprecated("use getMethod() or getFilmStart()")]] InitialSurface getInitialSurface() const {
    return options_.initial_surface;
  }

  /** \brief Set how dangling plates are removed and the topology is corrected. */
  void setFieldMethod(FieldMethod field) { options_.field = field; }

  /** \brief Get how dangling plates are removed and the topology is corrected. */
  FieldMethod getFieldMethod() const { return options_.field; }

  /** \brief Set which ring of triangles a site keeps when it owns several regions of the film. */
  void setRingChoice(RingChoice ring) { options_.ring = ring; }

  /** \brief Get which ring of triangles a site keeps when it owns several regions of the film. */
  RingChoice getRingChoice() const { return options_.ring; }

  /** \brief Set the number of virtual sites, or Options::kAdaptiveVirtualSites. */
  void setVirtualSites(int virtual_sites) { options_.virtual_sites = virtual_sites; }

  /** \brief Get the number of virtual sites. */
  int getVirtualSites() const { return options_.virtual_sites; }

  /** \brief Set whether stalled sites are attracted by weights. */
  void setUseWeights(bool use_weights) { options_.weights = use_weights; }

  /** \brief Get whether stalled sites are attracted by weights. */
  bool getUseWeights() const { return options_.weights; }

  /** \brief Set whether the sites that the film does not reach are put into its nearest face. */
  void setInsertLeftover(bool insert_leftover) { options_.insert_leftover = insert_leftover; }

  /** \brief Get whether the sites that the film does not reach are put into its nearest face. */
  bool getInsertLeftover() const { return options_.insert_leftover; }

  /** \brief Set whether the faces that no data supports are left out: of a scan
   * from one side the visible surface is left, a manifold with boundary, whose pieces face one viewpoint
   * on the convex side of the largest, where one sees that, or that of a depth image. A cloud from all sides
   * stays closed. Off by default. See getFaceGaps().
   */
  void setOutputBoundary(bool output_boundary) { options_.open_boundary = output_boundary; }

  /** \brief Get whether the faces that no data supports are left out. */
  bool getOutputBoundary() const { return options_.open_boundary; }

  /** \brief Set where the points may have been seen from, in place of the cloud's sensor origin.
   *
   * A depth image (an organized cloud of a depth camera, or all that is left of one) gives the surface that
   * shows all its faces to its viewpoint with setOutputBoundary(), and else what is behind it. Mostly the
   * points themselves say where that is; where they do not, as they are thinned or noisy, this is tried. Of
   * points that cannot all be seen from there, or are as well understood without, it changes nothing.
   */
  void setViewPoint(float vpx, float vpy, float vpz) { options_.viewpoint = {vpx, vpy, vpz}; }

  /** \brief Try no viewpoint: nothing is known of the sensor. */
  void useNoViewPoint() {
    options_.viewpoint.reset();
    try_sensor_origin_ = false;
  }

  /** \brief Try the sensor origin of the input cloud as the viewpoint, that of a blob being the origin: the
   * default. */
  void useSensorOriginAsViewPoint() {
    options_.viewpoint.reset();
    try_sensor_origin_ = true;
  }

  /** \brief Get the viewpoint that is tried; zeros if none is. */
  void getViewPoint(float& vpx, float& vpy, float& vpz) const {
    const filmsticking::Point point = viewPoint().value_or(filmsticking::Point{});
    vpx = static_cast<float>(point[0]), vpy = static_cast<float>(point[1]),
    vpz = static_cast<float>(point[2]);
  }

  /** \brief Set whether outliers, points far from all others, are brought on to the surface, too. Off by
   * default; Report::outliers tells how many were left off.
   */
  void setKeepOutliers(bool keep_outliers) { options_.keep_outliers = keep_outliers; }

  /** \brief Get whether outliers are brought on to the surface. */
  bool getKeepOutliers() const { return options_.keep_outliers; }

  /** \brief Set whether edges of the finished surface are flipped where that lays them along the shape's
   * sharp edges. On by default; the vertices are the same either way.
   */
  void setSharpEdges(bool sharp_edges) { options_.sharp_edges = sharp_edges; }

  /** \brief Get whether edges are flipped along the shape's sharp edges. */
  bool getSharpEdges() const { return options_.sharp_edges; }

  /** \brief Set the bytes that a reconstruction may take beside its input; 0, the default: no limit. One that
   * would need more (by an estimate) ends with Status::OutOfMemory.
   */
  void setMaxMemory(std::int64_t max_memory) { options_.max_memory = max_memory; }

  /** \brief Get the bytes that a reconstruction may take. */
  std::int64_t getMaxMemory() const { return options_.max_memory; }

  /** \brief The gap that each output triangle bridges: the diameter of the smallest circle around it, in
   * spacings of the points there. About 1.5 where the points are dense enough for their surface; large where
   * the surface was closed without data. Empty on failure.
   */
  const std::vector<float>& getFaceGaps() const { return face_gaps_; }

  /** \brief Set the number of film steps allowed before the first field. */
  void setMaxSteps(int max_steps) { options_.max_steps = max_steps; }

  /** \brief Get the number of film steps allowed before the first field. */
  int getMaxSteps() const { return options_.max_steps; }

  /** \brief Set the number of rounds of field and film allowed. */
  void setMaxRounds(int max_rounds) { options_.max_rounds = max_rounds; }

  /** \brief Get the number of rounds of field and film allowed. */
  int getMaxRounds() const { return options_.max_rounds; }

  /** \brief Set the number of threads; 0 stands for all that the machine has. */
  void setNumberOfThreads(int threads = 0) { options_.threads = threads; }

  /** \brief Get the number of threads; 0 stands for all that the machine has. */
  int getNumberOfThreads() const { return options_.threads; }

  /** \brief Set the surface that the film starts from, and FilmStart::Given with it.
   * \param[in] surface a closed, oriented 2-manifold; null takes the surface back and leaves the rest
   */
  void setGuidingSurface(const std::shared_ptr<const filmsticking::Mesh>& surface) {
    options_.guiding_surface = surface;
    if (surface) setFilmStart(FilmStart::Given);
  }

  /** \brief Set the surface that the film starts from, and FilmStart::Given with it.
   * \param[in] surface a closed, oriented 2-manifold; polygons are cut into triangles
   */
  void setGuidingSurface(const pcl::PolygonMesh& surface);

  /** \brief Get the surface set by setGuidingSurface(); null if there is none. */
  std::shared_ptr<const filmsticking::Mesh> getGuidingSurface() const { return options_.guiding_surface; }

  /** \brief Set all options at once. */
  void setOptions(const Options& options) { options_ = options; }

  /** \brief Get all options. */
  const Options& getOptions() const { return options_; }

  /** \brief Set a function that is called during reconstruct(), from the thread that called it, with the
   * share done (0 to 1, never falling) and the part of the method at work.
   */
  void setProgressCallback(const ProgressCallback& callback) { progress_callback_ = callback; }

  /** \brief Set a function that is called during reconstruct() with the film after every step. */
  void setStepCallback(const StepCallback& callback) { step_callback_ = callback; }

 protected:
  using SurfaceReconstruction<PointInT>::check_tree_;
  using SurfaceReconstruction<PointInT>::fake_indices_;
  using SurfaceReconstruction<PointInT>::use_indices_;

  /** \brief Reconstruct from an input that has been checked. */
  void performReconstruction(pcl::PolygonMesh& output) override;

  /** \brief Reconstruct from an input that has been checked. */
  void performReconstruction(pcl::PointCloud<PointInT>& points,
                             std::vector<pcl::Vertices>& polygons) override;

  /** \brief Class get name method. */
  std::string getClassName() const override { return "FilmstickingPP"; }

 private:
  /** \brief A flag for other threads; every object has its own, also a copied one. */
  struct CancelFlag {
    CancelFlag() = default;
    CancelFlag(const CancelFlag&) noexcept {}
    CancelFlag& operator=(CancelFlag) noexcept { return *this; }
    std::atomic<bool> raised{false};
  };

  /** \brief Forget the last result, run \a compute on the checked input, and turn exceptions into a status.
   */
  template <typename Compute>
  void guarded(Compute compute) noexcept;

  /** \brief Use the whole cloud from now on. */
  void useAllPoints();

  /** \brief Prepare the indices; false, with the status set, if the input cannot be used. */
  bool checkInput();

  /** \brief Fill \a triangles and what getVertexIndices() and others return; false, with the status set, if
   * there is no surface.
   */
  bool computeTriangles(std::vector<filmsticking::Triangle>& triangles);

  /** \brief The same for \a polygons. */
  bool computePolygons(std::vector<pcl::Vertices>& polygons);

  /** \brief Copy the vertices of the last result with all their fields. */
  void copyVertices(pcl::PCLPointCloud2& vertices) const;

  /** \brief The mesh of the indexed points, which are read where they lie if x, y and z are floats in a row.
   */
  filmsticking::Result computeResult(const filmsticking::Execution& execution) const;

  /** \brief The same for the blob's points, whose x, y and z are of type \a Real. */
  template <typename Real>
  filmsticking::Result computeResultOfBlob(const filmsticking::Execution& execution) const;

  /** \brief The viewpoint that is tried, if one is. */
  std::optional<filmsticking::Point> viewPoint() const;

  /** \brief The header of the blob or cloud; an empty one if there is neither. */
  pcl::PCLHeader inputHeader() const;

  /** \brief Set a failure and report it by PCL_ERROR. */
  void fail(Status status, const std::string& message);

  pcl::PCLPointCloud2::ConstPtr blob_;
  std::string indices_fault_;  // why a window was refused; empty: it was not

  Options options_;
  bool try_sensor_origin_ = true;
  ProgressCallback progress_callback_;
  StepCallback step_callback_;
  CancelFlag cancel_;
  const std::atomic<bool>* cancel_flag_ = nullptr;

  Status status_ = Status::InternalError;
  std::string status_message_;
  Report report_;
  pcl::Indices vertex_indices_;
  std::vector<float> face_gaps_;
};

}  // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface/impl/filmsticking_pp.hpp>
#endif
