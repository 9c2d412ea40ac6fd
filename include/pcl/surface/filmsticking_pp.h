// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
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
 * Every vertex of the result is an input point, copied with all its fields; getVertexIndices() gives its
 * index. The surface is closed, 2-manifold and wound counter-clockwise seen from outside. Points with a
 * coordinate that is not finite, repeated points and outliers (setKeepOutliers()) are left out. Normals are
 * copied like any other field and not used. No parameter has to be set:
 *
 * \code
 * pcl::FilmstickingPP<pcl::PointXYZ> filmsticking;
 * filmsticking.setInputCloud(cloud);
 * pcl::PolygonMesh mesh;
 * filmsticking.reconstruct(mesh);
 * if (filmsticking.getStatus() != filmsticking::Status::Ok) { ... }  // the mesh is empty then
 * \endcode
 *
 * reconstruct() never throws. It answers any input with a mesh, or with an empty one, a status and one line
 * of PCL_ERROR. Fewer than four distinct points, and points on one line or plane, enclose no volume and are
 * refused. The same input gives the same mesh, for any number of threads and in any object. Different objects
 * may run in different threads at once. The method does not search the input's neighbours: a search method,
 * if set, is kept and not used.
 *
 * To replace pcl::GreedyProjectionTriangulation or pcl::Poisson through pcl::PCLSurfaceBase, change the
 * constructor only. Unlike the former's, the mesh contains only the vertices of its faces.
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
  using InitialSurface = filmsticking::InitialSurface;  ///< Deprecated; removed in version 0.3.
  using FieldMethod = filmsticking::FieldMethod;        ///< What corrects a film's topology.
  using RingChoice = filmsticking::RingChoice;          ///< Which of several regions a site keeps.
  using Options = filmsticking::Options;                ///< All options.
  using Status = filmsticking::Status;                  ///< How a reconstruction ended.
  using Report = filmsticking::Report;                  ///< What a reconstruction did.

  /** \brief Receives the fraction done, from 0 to 1, and the current stage. */
  using ProgressCallback = std::function<void(double share, const char* stage)>;

  /** \brief Receives the film after a step (0: the initial surface), in the input's coordinates. */
  using StepCallback = std::function<void(int step, const filmsticking::Mesh& film)>;

  using SurfaceReconstruction<PointInT>::input_;
  using SurfaceReconstruction<PointInT>::indices_;

  /** \brief Constructor: the defaults of filmsticking::Options. */
  FilmstickingPP() { check_tree_ = false; }

  /** \brief Destructor. */
  ~FilmstickingPP() override = default;

  /** \brief Set the input cloud; replaces one set by setInputBlob().
   * \param[in] cloud the points, with or without normals, organized or not, dense or not
   */
  void setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Set the input as a blob, to keep fields that \a PointInT does not have.
   *
   * reconstruct(pcl::PolygonMesh&) then copies the bytes of every vertex and the layout of the fields from
   * the blob; the other reconstruct() converts the vertices as pcl::fromPCLPointCloud2() does. The blob is
   * read where it lies and must not change meanwhile; getInputCloud() is null.
   * \param[in] blob points with fields x, y and z, all FLOAT32 or all FLOAT64, not big-endian; another kind
   * is refused by reconstruct(). FLOAT64 is read with all its digits
   */
  void setInputBlob(const pcl::PCLPointCloud2::ConstPtr& blob);

  /** \brief Get the input set by setInputBlob(); null if the input was set otherwise. */
  pcl::PCLPointCloud2::ConstPtr getInputBlob() const { return blob_; }

  /** \brief Set the points to use; null: all points. */
  void setIndices(const pcl::IndicesPtr& indices) override;

  /** \brief Set the points to use; null: all points. The indices are copied. */
  void setIndices(const pcl::IndicesConstPtr& indices) override;

  /** \brief Set the points to use; null: all points. The indices are copied. */
  void setIndices(const PointIndicesConstPtr& indices) override;

  /** \brief Use a window of an organized cloud. Set the input cloud before. reconstruct() refuses a window
   * that is not in the cloud. \param[in] row_start first row \param[in] col_start first column \param[in]
   * nb_rows number of rows \param[in] nb_cols number of columns
   */
  void setIndices(std::size_t row_start, std::size_t col_start, std::size_t nb_rows,
                  std::size_t nb_cols) override;

  /** \brief Reconstruct the surface through the points given by setInputCloud() or setInputBlob(), and
   * setIndices().
   * \param[out] output the triangles, and a cloud with their vertices only, unorganized and dense; empty on
   * failure. The headers are the input's.
   */
  void reconstruct(pcl::PolygonMesh& output) override;

  /** \brief Reconstruct the surface through the points given by setInputCloud() or setInputBlob(), and
   * setIndices().
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

  /** \brief Set a function that reconstruct() calls from its own thread with the fraction done, 0 to 1 and
   * never falling, and the current stage.
   */
  void setProgressCallback(const ProgressCallback& callback) { progress_callback_ = callback; }

  /** \brief Set a function that reconstruct() calls with the film after every step. */
  void setStepCallback(const StepCallback& callback) { step_callback_ = callback; }

  /** \brief Stop the running reconstruction, from any thread: it ends soon with Status::Cancelled. No effect
   * if none is running. See setCancelFlag().
   */
  void cancel() { cancel_.raised = true; }

  /** \brief Listen to a flag of the caller's in place of cancel(), as a signal handler may set it.
   * \param[in] flag must outlive the reconstruction; null stands for cancel()
   */
  void setCancelFlag(const std::atomic<bool>* flag) { cancel_flag_ = flag; }

  /** \brief How the last reconstruct() ended; InternalError before the first. */
  Status getStatus() const { return status_; }

  /** \brief One sentence on the failure of the last reconstruct(); empty if it succeeded. */
  const std::string& getStatusMessage() const { return status_message_; }

  /** \brief What the last reconstruct() did, up to a failure. */
  const Report& getReport() const { return report_; }

  /** \brief The input point of each output vertex.
   * \return for vertex k its index in the input cloud (also when setIndices() was used); empty on failure
   */
  const pcl::Indices& getVertexIndices() const { return vertex_indices_; }

  /** \brief The gap that each output triangle bridges: the diameter of its smallest enclosing circle, in
   * spacings of the points there. About 1.5 where the points are dense enough for the surface; large where it
   * was closed without data. Empty on failure.
   */
  const std::vector<float>& getFaceGaps() const { return face_gaps_; }

  /** \brief The confidence in each output triangle, from 0 to 1: how much of the surface around it one more
   * film step would keep. Low in thin plates, chance gaps and noise. Empty without setComputeStability(),
   * on failure, for the open surface of a depth image, and for a cloud so flat that the last resort made
   * its surface.
   */
  const std::vector<float>& getFaceStability() const { return face_stability_; }

  /** \brief One unit normal for every point of the input cloud, oriented by the surface; of curvature 0.
   *
   * Points that are no vertices, and those that setIndices() leaves out, have the normal at the nearest place
   * on the surface; points that are not finite have NaN. pcl::concatenateFields() joins them with the cloud.
   * Empty without setComputeNormals() and on failure.
   */
  const pcl::PointCloud<pcl::Normal>& getNormals() const { return normals_; }

  /** \name Options that most callers need
   * Most callers need setInputCloud() and at most these six setters. */
  ///@{

  /** \brief Set whether the result may have a boundary: faces that no data support are removed.
   *
   * A scan from one side gives its visible surface, a manifold with boundary. A cloud sampled from all sides
   * stays closed. The open components of a scan show the same side to one viewpoint: the sensor of a depth
   * image, else the side on which the largest component is convex. Off by default. See getFaceGaps().
   */
  void setOutputBoundary(bool output_boundary) { options_.open_boundary = output_boundary; }

  /** \brief Get whether the result may have a boundary. */
  bool getOutputBoundary() const { return options_.open_boundary; }

  /** \brief Set the largest hole to close: between a closed result and an open one.
   *
   * The result may have a boundary, but rims whose diameter is at most \a length get a lid. A lid has
   * no new vertices, and avoids other faces where it can. A rim stays open only where a lid would break the
   * manifold or lie on the surface. getReport().holes lists all rims.
   * \param[in] length in the unit of the points; 0, the default: setOutputBoundary() alone decides
   */
  void setMaxHole(double length) { options_.max_hole = length; }

  /** \brief Get the largest hole to close. */
  double getMaxHole() const { return options_.max_hole; }

  /** \brief Set the sensor position, instead of the sensor origin of the cloud.
   *
   * Used only if the points do not reveal it, as in thinned or noisy depth images, and if the surface seen
   * from it is better. With setOutputBoundary() all faces of a depth image show their fronts to the sensor;
   * else everything behind the image is inside.
   */
  void setViewPoint(float vpx, float vpy, float vpz) { options_.viewpoint = {vpx, vpy, vpz}; }

  /** \brief Set the way in which a far sensor looks at all points: (0, 0, -1) from above, as for height
   * fields. Instead of a viewpoint.
   */
  void setViewDirection(float x, float y, float z) { options_.view_direction = {x, y, z}; }

  /** \brief Use no viewpoint: nothing is known of the sensor. */
  void useNoViewPoint() {
    options_.viewpoint.reset();
    options_.view_direction.reset();
    try_sensor_origin_ = false;
  }

  /** \brief Use the sensor origin of the input cloud as the viewpoint, the default; a blob's is the origin of
   * its frame. */
  void useSensorOriginAsViewPoint() {
    options_.viewpoint.reset();
    try_sensor_origin_ = true;
  }

  /** \brief Get the viewpoint; zeros if there is none. */
  void getViewPoint(float& vpx, float& vpy, float& vpz) const {
    const filmsticking::Point point = viewPoint().value_or(filmsticking::Point{});
    vpx = static_cast<float>(point[0]), vpy = static_cast<float>(point[1]),
    vpz = static_cast<float>(point[2]);
  }

  /** \brief Set the number of threads; 0, the default: all of the machine. The result does not depend on it.
   */
  void setNumberOfThreads(int threads = 0) { options_.threads = threads; }

  /** \brief Get the number of threads; 0: all of the machine. */
  int getNumberOfThreads() const { return options_.threads; }

  ///@}

  /** \name All options at once */
  ///@{

  /** \brief Set all options, for example Options::paper() or Options::rd(). */
  void setOptions(const Options& options) { options_ = options; }

  /** \brief Get all options. */
  const Options& getOptions() const { return options_; }

  ///@}

  /** \name Further options */
  ///@{

  /** \brief Set the most memory in bytes, without the input; 0, the default: no limit. A reconstruction that
   * needs more, by an estimate, ends with Status::OutOfMemory.
   */
  void setMaxMemory(std::int64_t max_memory) { options_.max_memory = max_memory; }

  /** \brief Get the most memory in bytes. */
  std::int64_t getMaxMemory() const { return options_.max_memory; }

  /** \brief Set whether outliers, points far from all others, are kept. Off by default; Report::outliers
   * counts those left out.
   */
  void setKeepOutliers(bool keep_outliers) { options_.keep_outliers = keep_outliers; }

  /** \brief Get whether outliers are kept. */
  bool getKeepOutliers() const { return options_.keep_outliers; }

  /** \brief Set whether edges of the finished surface are flipped to lie along sharp edges. On by default;
   * the vertices are the same either way.
   */
  void setSharpEdges(bool sharp_edges) { options_.sharp_edges = sharp_edges; }

  /** \brief Get whether edges are flipped to lie along sharp edges. */
  bool getSharpEdges() const { return options_.sharp_edges; }

  /** \brief Set whether getFaceStability() is filled, in about a tenth more time. Off by default. */
  void setComputeStability(bool stability) { options_.stability = stability; }

  /** \brief Get whether getFaceStability() is filled. */
  bool getComputeStability() const { return options_.stability; }

  /** \brief Set whether getNormals() is filled, in a few per cent more time. Off by default. */
  void setComputeNormals(bool normals) { compute_normals_ = normals; }

  /** \brief Get whether getNormals() is filled. */
  bool getComputeNormals() const { return compute_normals_; }

  /** \brief Set whether points that the surface misses are inserted at the end. On by default. */
  void setInsertLeftover(bool insert_leftover) { options_.insert_leftover = insert_leftover; }

  /** \brief Get whether points that the surface misses are inserted at the end. */
  bool getInsertLeftover() const { return options_.insert_leftover; }

  ///@}

  /** \name Options for comparisons with the paper */
  ///@{

  /** \brief Set what makes the surface: labelled tetrahedra (the default), or the paper's film. */
  void setMethod(Method method) {
    options_.method = method;
    options_.initial_surface = InitialSurface::Carve;
  }

  /** \brief Get what makes the surface. */
  Method getMethod() const { return filmsticking::method_of(options_); }

  /** \brief Set the surface that a film starts from, and Method::Film. */
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

  /** \brief Set how a film loses its dangling plates and its topology is corrected. */
  void setFieldMethod(FieldMethod field) { options_.field = field; }

  /** \brief Get how a film loses its dangling plates and its topology is corrected. */
  FieldMethod getFieldMethod() const { return options_.field; }

  /** \brief Set what gives way where a site would own several regions of the film. */
  void setRingChoice(RingChoice ring) { options_.ring = ring; }

  /** \brief Get what gives way where a site would own several regions of the film. */
  RingChoice getRingChoice() const { return options_.ring; }

  /** \brief Set the number of virtual sites, or Options::kAdaptiveVirtualSites. */
  void setVirtualSites(int virtual_sites) { options_.virtual_sites = virtual_sites; }

  /** \brief Get the number of virtual sites. */
  int getVirtualSites() const { return options_.virtual_sites; }

  /** \brief Set whether weights attract sites off a stalled film. */
  void setUseWeights(bool use_weights) { options_.weights = use_weights; }

  /** \brief Get whether weights attract sites off a stalled film. */
  bool getUseWeights() const { return options_.weights; }

  /** \brief Set the most film steps before the first field. */
  void setMaxSteps(int max_steps) { options_.max_steps = max_steps; }

  /** \brief Get the most film steps before the first field. */
  int getMaxSteps() const { return options_.max_steps; }

  /** \brief Set the most rounds of field and cut. */
  void setMaxRounds(int max_rounds) { options_.max_rounds = max_rounds; }

  /** \brief Get the most rounds of field and cut. */
  int getMaxRounds() const { return options_.max_rounds; }

  /** \brief Set the surface that a film starts from, and FilmStart::Given.
   * \param[in] surface a closed, oriented 2-manifold; null removes the surface and changes nothing else
   */
  void setGuidingSurface(const std::shared_ptr<const filmsticking::Mesh>& surface) {
    options_.guiding_surface = surface;
    if (surface) setFilmStart(FilmStart::Given);
  }

  /** \brief Set the surface that a film starts from, and FilmStart::Given.
   * \param[in] surface a closed, oriented 2-manifold; polygons are split into triangles
   */
  void setGuidingSurface(const pcl::PolygonMesh& surface);

  /** \brief Get the surface set by setGuidingSurface(); null if there is none. */
  std::shared_ptr<const filmsticking::Mesh> getGuidingSurface() const { return options_.guiding_surface; }

  ///@}

 protected:
  using SurfaceReconstruction<PointInT>::check_tree_;
  using SurfaceReconstruction<PointInT>::fake_indices_;
  using SurfaceReconstruction<PointInT>::use_indices_;

  /** \brief Reconstruct from a checked input. */
  void performReconstruction(pcl::PolygonMesh& output) override;

  /** \brief Reconstruct from a checked input. */
  void performReconstruction(pcl::PointCloud<PointInT>& points,
                             std::vector<pcl::Vertices>& polygons) override;

  /** \brief Get the name of the class. */
  std::string getClassName() const override { return "FilmstickingPP"; }

 private:
  /** \brief The flag that cancel() raises; a copy of an object has its own. */
  struct CancelFlag {
    CancelFlag() = default;
    CancelFlag(const CancelFlag&) noexcept {}
    CancelFlag& operator=(CancelFlag) noexcept { return *this; }
    std::atomic<bool> raised{false};
  };

  /** \brief Clear the last result, run \a compute on the checked input and turn exceptions into a status. */
  template <typename Compute>
  void guarded(Compute compute) noexcept;

  /** \brief Forget the indices: use all points. */
  void useAllPoints();

  /** \brief Prepare the indices; false, with the status set, if the input cannot be used. */
  bool checkInput();

  /** \brief Fill \a triangles and the results that the getters return; false, with the status set, if
   * there is no surface.
   */
  bool computeTriangles(std::vector<filmsticking::Triangle>& triangles);

  /** \brief The same for \a polygons. */
  bool computePolygons(std::vector<pcl::Vertices>& polygons);

  /** \brief Copy the vertices of the last result with all their fields. */
  void copyVertices(pcl::PCLPointCloud2& vertices) const;

  /** \brief Call \a use with a view of all input points, which are read in place if x, y and z are
   * consecutive floats or doubles.
   */
  template <typename Use>
  auto withAllPoints(const Use& use) const;

  /** \brief The same for the points of the blob, whose x, y and z are of type \a Real. */
  template <typename Real, typename Use>
  auto withAllPointsOfBlob(const Use& use) const;

  /** \brief Fill normals_; false, with the status set, if that fails. */
  bool computeNormals(const std::vector<filmsticking::Triangle>& triangles,
                      const filmsticking::Execution& execution);

  /** \brief The viewpoint of the options, else the sensor origin of the cloud unless useNoViewPoint(). */
  std::optional<filmsticking::Point> viewPoint() const;

  /** \brief The header of the blob or cloud; empty without input. */
  pcl::PCLHeader inputHeader() const;

  /** \brief Set a failure and report it by PCL_ERROR. */
  void fail(Status status, const std::string& message);

  pcl::PCLPointCloud2::ConstPtr blob_;
  std::string indices_fault_;  // why a window is refused; empty: it is not

  Options options_;
  bool try_sensor_origin_ = true;
  bool compute_normals_ = false;
  ProgressCallback progress_callback_;
  StepCallback step_callback_;
  CancelFlag cancel_;
  const std::atomic<bool>* cancel_flag_ = nullptr;

  Status status_ = Status::InternalError;
  std::string status_message_;
  Report report_;
  pcl::Indices vertex_indices_;
  std::vector<float> face_gaps_;
  std::vector<float> face_stability_;
  pcl::PointCloud<pcl::Normal> normals_;
};

}  // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface/impl/filmsticking_pp.hpp>
#endif
