// SPDX-License-Identifier: GPL-3.0-or-later
#include <gif_lib.h>
#include <vtkImageAppend.h>
#include <vtkImageCast.h>
#include <vtkImageQuantizeRGBToIndex.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "image.h"
#include "io/io_error.h"

namespace filmsticking::scene {
namespace {

constexpr int kColours = 256;

/// Closes the file after an exception.
struct Closer {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
struct MapFreer {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

void check(bool fine) {
  if (!fine) throw io::IoError("the GIF could not be encoded");
}

int append(GifFileType* gif, const GifByteType* bytes, int count) {
  try {
    static_cast<std::string*>(gif->UserData)->append(reinterpret_cast<const char*>(bytes), count);
    return count;
  } catch (const std::bad_alloc&) {
    return 0;  // not through the library, which is C
  }
}

std::unique_ptr<ColorMapObject, MapFreer> make_map(vtkLookupTable* table) {
  std::unique_ptr<ColorMapObject, MapFreer> map(GifMakeMapObject(kColours, nullptr));
  check(map != nullptr);
  for (int i = 0; i < std::min<int>(kColours, static_cast<int>(table->GetNumberOfTableValues())); ++i) {
    const double* colour = table->GetTableValue(i);
    const auto byte = [&](int k) { return static_cast<GifByteType>(std::lround(255 * colour[k])); };
    map->Colors[i] = {byte(0), byte(1), byte(2)};
  }
  return map;
}

/// Netscape's extension, which all viewers know: repeat without end.
void put_loop(GifFileType* gif) {
  const GifByteType for_ever[] = {1, 0, 0};
  check(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
        EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") == GIF_OK &&
        EGifPutExtensionBlock(gif, sizeof for_ever, for_ever) == GIF_OK &&
        EGifPutExtensionTrailer(gif) == GIF_OK);
}

void put_delay(GifFileType* gif, int hundredths) {
  const GraphicsControlBlock control = {DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
  std::array<GifByteType, 4> bytes{};
  EGifGCBToExtension(&control, bytes.data());
  check(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()) == GIF_OK);
}

}  // namespace

std::string encode_gif(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                       double pictures_per_second) {
  // One choice of colours for all pictures, which are stacked for it: separate ones would flicker.
  vtkNew<vtkImageAppend> all;
  all->SetAppendAxis(1);
  for (const auto& picture : pictures) all->AddInputData(picture);
  vtkNew<vtkImageQuantizeRGBToIndex> quantizer;
  quantizer->SetInputConnection(all->GetOutputPort());
  quantizer->SetNumberOfColors(kColours);
  vtkNew<vtkImageCast> bytes_of_indices;
  bytes_of_indices->SetInputConnection(quantizer->GetOutputPort());
  bytes_of_indices->SetOutputScalarTypeToUnsignedChar();
  bytes_of_indices->Update();
  vtkImageData* indices = bytes_of_indices->GetOutput();
  const int width = pictures.at(0)->GetDimensions()[0], height = pictures[0]->GetDimensions()[1];

  std::string bytes;
  std::unique_ptr<GifFileType, Closer> gif(EGifOpen(&bytes, append, nullptr));
  check(gif != nullptr);
  EGifSetGifVersion(gif.get(), true);
  const auto map = make_map(quantizer->GetLookupTable());
  check(EGifPutScreenDesc(gif.get(), width, height, 8, 0, map.get()) == GIF_OK);
  put_loop(gif.get());
  std::vector<GifPixelType> line(width);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    put_delay(gif.get(), std::max(2, static_cast<int>(std::lround(100 / pictures_per_second))));
    check(EGifPutImageDesc(gif.get(), 0, 0, width, height, false, nullptr) == GIF_OK);
    for (int y = height - 1; y >= 0; --y) {  // VTK's pictures start at the bottom
      const auto* row = static_cast<const unsigned char*>(
          indices->GetScalarPointer(0, static_cast<int>(i) * height + y, 0));
      std::copy_n(row, width, line.begin());  // the library takes no constant line
      check(EGifPutLine(gif.get(), line.data(), width) == GIF_OK);
    }
  }
  int error = 0;
  check(EGifCloseFile(gif.release(), &error) == GIF_OK);
  return bytes;
}

}  // namespace filmsticking::scene
