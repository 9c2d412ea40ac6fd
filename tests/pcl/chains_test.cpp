// SPDX-License-Identifier: GPL-3.0-or-later
// pcl::FilmstickingPP between the other classes of PCL: what goes in before it and what comes after it.
#include <gtest/gtest.h>
#include <pcl/filters/farthest_point_sampling.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/random_sample.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/geometry/mesh_conversion.h>
#include <pcl/geometry/polygon_mesh.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/vtk_io.h>
#include <pcl/io/vtk_lib_io.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/filmsticking_pp.h>
#include <pcl/surface/mls.h>
#include <pcl/surface/simplification_remove_unused_vertices.h>
#include <pcl/surface/texture_mapping.h>
#include <pcl/surface/vtk_smoothing/vtk_mesh_smoothing_laplacian.h>
#include <pcl/surface/vtk_smoothing/vtk_mesh_smoothing_windowed_sinc.h>
#include <pcl/surface/vtk_smoothing/vtk_mesh_subdivision.h>

#include <cstring>
#include <string>

#include "mesh.h"
#include "support/scratch_folder.h"
#include "support/surface_check.h"

namespace filmsticking::test {
namespace {

using pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointXYZ>;

Cloud::Ptr load_spot() {
  Cloud::Ptr cloud(new Cloud);
  EXPECT_EQ(pcl::io::loadPLYFile(TEST_DATA "/spot_10k.ply", *cloud), 0);
  return cloud;
}

/// Meshes `cloud` and expects the promise to hold on it.
template <typename PointT>
pcl::PolygonMesh::Ptr expect_mesh(const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
                                  const pcl::IndicesPtr& indices = nullptr) {
  pcl::FilmstickingPP<PointT> film;
  film.setInputCloud(cloud);
  film.setIndices(indices);
  pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
  film.reconstruct(*mesh);
  EXPECT_EQ(film.getStatus(), Status::Ok) << film.getStatusMessage();
  EXPECT_EQ(surface_fault(to_mesh(*mesh)), "");
  EXPECT_GT(signed_volume(to_mesh(*mesh)), 0);
  const std::size_t points = indices ? indices->size() : cloud->size();
  EXPECT_GT(film.getVertexIndices().size(), points * 9 / 10);
  pcl::PointCloud<PointT> vertices;
  pcl::fromPCLPointCloud2(mesh->cloud, vertices);
  EXPECT_EQ(vertices.size(), film.getVertexIndices().size());
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const int id = film.getVertexIndices()[k];
    EXPECT_TRUE(!indices || std::find(indices->begin(), indices->end(), id) != indices->end());
    EXPECT_EQ(std::memcmp(&vertices[k].x, &(*cloud)[id].x, 3 * sizeof(float)), 0) << k;
  }
  return mesh;
}

/// By the cloud that a filter returns, and by its indices.
template <typename Filter>
void expect_mesh_after(Filter& filter) {
  filter.setInputCloud(load_spot());
  Cloud::Ptr filtered(new Cloud);
  filter.filter(*filtered);
  ASSERT_GT(filtered->size(), 500u);
  ASSERT_LT(filtered->size(), 10000u);
  expect_mesh<PointXYZ>(filtered);
}

TEST(ChainBefore, PassThrough) {
  pcl::PassThrough<PointXYZ> filter;
  filter.setFilterFieldName("x");
  filter.setFilterLimits(-10, 0);
  expect_mesh_after(filter);
  // The same by indices, and with an organized cloud full of holes.
  const auto cloud = load_spot();
  filter.setInputCloud(cloud);
  const pcl::IndicesPtr indices(new pcl::Indices);
  filter.filter(*indices);
  expect_mesh<PointXYZ>(cloud, indices);
  cloud->width = 100;
  cloud->height = 100;
  filter.setKeepOrganized(true);
  Cloud::Ptr organized(new Cloud);
  filter.filter(*organized);
  ASSERT_EQ(organized->height, 100u);
  pcl::FilmstickingPP<PointXYZ> film;
  film.setInputCloud(organized);
  pcl::PolygonMesh mesh;
  film.reconstruct(mesh);
  EXPECT_EQ(surface_fault(to_mesh(mesh)), "");
  EXPECT_EQ(film.getReport().non_finite + static_cast<std::int64_t>(indices->size()), 10000);
}

TEST(ChainBefore, VoxelGrid) {
  pcl::VoxelGrid<PointXYZ> filter;
  filter.setLeafSize(0.03f, 0.03f, 0.03f);
  expect_mesh_after(filter);
}

TEST(ChainBefore, StatisticalOutlierRemoval) {
  pcl::StatisticalOutlierRemoval<PointXYZ> filter;
  filter.setMeanK(10);
  filter.setStddevMulThresh(1);
  expect_mesh_after(filter);
}

TEST(ChainBefore, RandomSample) {
  pcl::RandomSample<PointXYZ> filter;
  filter.setSample(2000);
  expect_mesh_after(filter);
}

TEST(ChainBefore, FarthestPointSampling) {
  pcl::FarthestPointSampling<PointXYZ> filter;
  filter.setSample(1000);
  filter.setSeed(1);
  expect_mesh_after(filter);
}

TEST(ChainBefore, MovingLeastSquares) {
  pcl::MovingLeastSquares<PointXYZ, pcl::PointNormal> smoother;
  smoother.setInputCloud(load_spot());
  smoother.setSearchMethod(pcl::search::KdTree<PointXYZ>::Ptr(new pcl::search::KdTree<PointXYZ>));
  smoother.setSearchRadius(0.05);
  smoother.setComputeNormals(true);
  pcl::PointCloud<pcl::PointNormal>::Ptr smooth(new pcl::PointCloud<pcl::PointNormal>);
  smoother.process(*smooth);
  ASSERT_GT(smooth->size(), 9000u);
  expect_mesh<pcl::PointNormal>(smooth);
}

/// A mesh to go on with.
class ChainAfter : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    pcl::RandomSample<PointXYZ> sample;
    sample.setInputCloud(load_spot());
    sample.setSample(2000);
    sample.setSeed(1);
    Cloud::Ptr cloud(new Cloud);
    sample.filter(*cloud);
    mesh = expect_mesh<PointXYZ>(cloud);
  }
  static void TearDownTestSuite() { mesh.reset(); }
  static pcl::PolygonMesh::Ptr mesh;
};
pcl::PolygonMesh::Ptr ChainAfter::mesh;

TEST_F(ChainAfter, MeshSmoothing) {
  const auto expect_smooth = [&](pcl::MeshProcessing& smoother) {
    smoother.setInputMesh(mesh);
    pcl::PolygonMesh smooth;
    smoother.process(smooth);
    EXPECT_EQ(smooth.polygons.size(), mesh->polygons.size());
    EXPECT_EQ(surface_fault(to_mesh(smooth)), "");
  };
  pcl::MeshSmoothingLaplacianVTK laplacian;
  expect_smooth(laplacian);
  pcl::MeshSmoothingWindowedSincVTK windowed_sinc;
  expect_smooth(windowed_sinc);
}

TEST_F(ChainAfter, MeshSubdivision) {
  pcl::MeshSubdivisionVTK subdivision;
  subdivision.setFilterType(pcl::MeshSubdivisionVTK::LOOP);  // fails on a mesh that is not a manifold
  subdivision.setInputMesh(mesh);
  pcl::PolygonMesh fine;
  subdivision.process(fine);
  EXPECT_EQ(fine.polygons.size(), 4 * mesh->polygons.size());
  EXPECT_EQ(surface_fault(to_mesh(fine)), "");
}

TEST_F(ChainAfter, RemoveUnusedVerticesFindsNone) {
  pcl::surface::SimplificationRemoveUnusedVertices remover;
  pcl::PolygonMesh simple;
  remover.simplify(*mesh, simple);
  EXPECT_EQ(simple.cloud.width, mesh->cloud.width);
}

TEST_F(ChainAfter, HalfEdgeMesh) {
  struct Traits {
    using VertexData = PointXYZ;
    using HalfEdgeData = pcl::geometry::NoData;
    using EdgeData = pcl::geometry::NoData;
    using FaceData = pcl::geometry::NoData;
    using IsManifold = std::false_type;  // true refuses faces that touch others at a vertex only, for now
  };
  pcl::geometry::PolygonMesh<Traits> half_edges;
  EXPECT_EQ(pcl::geometry::toHalfEdgeMesh(*mesh, half_edges), 0);
  EXPECT_TRUE(half_edges.isManifold());
  EXPECT_EQ(half_edges.sizeFaces(), mesh->polygons.size());
  EXPECT_EQ(half_edges.sizeVertices(), mesh->cloud.width);
  EXPECT_EQ(half_edges.sizeEdges() * 2, half_edges.sizeFaces() * 3);
  for (std::size_t e = 0; e < half_edges.sizeHalfEdges(); ++e)
    EXPECT_FALSE(half_edges.isBoundary(pcl::geometry::HalfEdgeIndex(static_cast<int>(e))));
  // And back, and the next class takes it.
  pcl::PolygonMesh back;
  pcl::geometry::toFaceVertexMesh(half_edges, back);
  EXPECT_EQ(surface_fault(to_mesh(back)), "");
}

TEST_F(ChainAfter, TextureMapping) {
  pcl::TextureMesh textured;
  textured.header = mesh->header;
  textured.cloud = mesh->cloud;
  textured.tex_polygons = {mesh->polygons};
  textured.tex_materials.resize(1);
  textured.tex_materials[0].tex_name = "material";
  textured.tex_materials[0].tex_file = "picture.png";
  pcl::TextureMapping<PointXYZ> mapping;
  mapping.setF(0.1f);
  mapping.setVectorField(1, 0, 0);
  mapping.setTextureFiles({"picture.png"});
  pcl::TexMaterial material;
  material.tex_name = "material";
  mapping.setTextureMaterials(material);
  textured.tex_materials.clear();
  mapping.mapTexture2Mesh(textured);
  ASSERT_EQ(textured.tex_coordinates.size(), 1u);
  EXPECT_EQ(textured.tex_coordinates[0].size(), 3 * mesh->polygons.size());
}

/// What PCL writes of the mesh it reads back as the same mesh.
template <typename Save>
void expect_kept(const pcl::PolygonMesh& mesh, const std::string& name, Save save) {
  const ScratchFolder folder;
  const std::string path = folder / name;
  save(path);
  pcl::PolygonMesh again;
  ASSERT_GT(pcl::io::loadPolygonFile(path, again), 0) << name;
  EXPECT_EQ(again.polygons.size(), mesh.polygons.size()) << name;
  EXPECT_EQ(again.cloud.width, mesh.cloud.width) << name;
  EXPECT_EQ(surface_fault(to_mesh(again)), "") << name;
}

TEST_F(ChainAfter, Save) {
  expect_kept(*mesh, "mesh.ply",
              [&](const std::string& path) { EXPECT_EQ(pcl::io::savePLYFile(path, *mesh, 9), 0); });
  expect_kept(*mesh, "binary.ply",
              [&](const std::string& path) { EXPECT_EQ(pcl::io::savePLYFileBinary(path, *mesh), 0); });
  expect_kept(*mesh, "mesh.obj",
              [&](const std::string& path) { EXPECT_EQ(pcl::io::saveOBJFile(path, *mesh, 9), 0); });
  expect_kept(*mesh, "mesh.vtk",
              [&](const std::string& path) { EXPECT_EQ(pcl::io::saveVTKFile(path, *mesh, 9), 0); });
  expect_kept(*mesh, "mesh.stl",
              [&](const std::string& path) { EXPECT_TRUE(pcl::io::savePolygonFileSTL(path, *mesh)); });
}

TEST_F(ChainAfter, TheCloudCanBeSavedAlone) {
  const ScratchFolder folder;
  const std::string path = folder / "vertices.pcd";
  ASSERT_EQ(pcl::io::savePCDFile(path, mesh->cloud), 0);
  Cloud cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(path, cloud), 0);
  EXPECT_EQ(cloud.size(), mesh->cloud.width);
}

}  // namespace
}  // namespace filmsticking::test
