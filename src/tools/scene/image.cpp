// SPDX-License-Identifier: GPL-3.0-or-later
#include "image.h"

#include <X11/Xlib.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "io/io_error.h"

namespace filmsticking::scene {

DisplayConnection::DisplayConnection() : display_(XOpenDisplay(nullptr)) {
  if (!display_) throw io::IoError("there is no X display; xvfb-run -a brings one");
}

DisplayConnection::~DisplayConnection() { XCloseDisplay(static_cast<Display*>(display_)); }

vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->Update();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image->GetOutput());
  return copy;
}

std::string encode_png(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                     static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

}  // namespace filmsticking::scene
