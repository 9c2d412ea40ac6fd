// SPDX-License-Identifier: GPL-3.0-or-later
#include "refused_formats.h"

#include "io_error.h"

namespace filmsticking::io {
namespace {

struct Known {
  std::string_view mark;  // the first bytes, or the extension
  const char* what;
};

constexpr Known kByBytes[] = {
    {"ASTM-E57", "it is an E57 file; convert it with 'pdal translate IN.e57 OUT.las' or CloudCompare"},
    {"CCB2", "it is a file of CloudCompare's own format; save it there as PLY"},
    {"DRACO", "it is a Draco file; decode it with 'draco_decoder -i IN.drc -o OUT.ply'"},
    {"glTF", "it is a glTF file; convert it with 'assimp export IN.glb OUT.ply'"},
    {"Kaydara FBX", "it is an FBX file; convert it with 'assimp export IN.fbx OUT.ply'"},
    {"\x93NUMPY", "it is a NumPy array; write it with numpy.savetxt('cloud.xyz', array)"},
    {"#ROSBAG", "it is a ROS bag; 'rosrun pcl_ros bag_to_pcd' writes its clouds as PCD"},
    {"\x1f\x8b", "it is compressed; unpack it with gunzip"},
    {"BZh", "it is compressed; unpack it with bunzip2"},
    {std::string_view("\xfd"
                      "7zXZ"),
     "it is compressed; unpack it with unxz"},
    {"\x28\xb5\x2f\xfd", "it is compressed; unpack it with unzstd"},
    {"PK\x03\x04", "it is a ZIP archive; unpack it with unzip"},
    {"\x89HDF", "it is an HDF5 file; write its points as PLY or text"},
    {"\xd4\xc3\xb2\xa1",
     "it is a capture of packets; convert it with the sensor's program, or VeloView, to CSV"},
    {"\x89PNG", "it is a picture, no cloud"},
    {"\xff\xd8\xff", "it is a picture, no cloud"},
    {"%PDF", "it is a PDF document, no cloud"},
    {"<", "it is XML or HTML; save the points as PLY, legacy VTK or text (ParaView: File, Save Data)"},
    {"{\"", "it is JSON; save the points as PLY or text"},
    {"{\n", "it is JSON; save the points as PLY or text"},
    {"{ ", "it is JSON; save the points as PLY or text"},
};

constexpr Known kByExtension[] = {
    {".laz", "it is no LAS file; decompress a LAZ file with 'laszip -i IN.laz -o OUT.las'"},
    {".rcs", "it is a scan of Autodesk ReCap; export it from ReCap as PTS, or as E57 for CloudCompare"},
    {".rcp", "it is a project of Autodesk ReCap; export it from ReCap as PTS, or as E57 for CloudCompare"},
    {".fls", "it is a scan of FARO; export it from SCENE as PTX, PTS or XYZ"},
    {".zfs", "it is a scan of Zoller+Froehlich; export it from LaserControl as PTX or ASC"},
    {".rdbx", "it is a database of RIEGL; export it from RiSCAN PRO as LAS"},
    {".ptg", "it is a binary scan of Leica; export it from Cyclone as PTX or PTS"},
    {".splat", "it has Gaussian splats, no points of a surface"},
    {".spz", "it has Gaussian splats, no points of a surface"},
};

}  // namespace

void refuse_unread_formats(std::string_view bytes, const std::string& extension) {
  for (const Known& known : kByBytes)
    if (bytes.substr(0, known.mark.size()) == known.mark) throw IoError(known.what);
  for (const Known& known : kByExtension)
    if (extension == known.mark) throw IoError(known.what);
}

}  // namespace filmsticking::io
