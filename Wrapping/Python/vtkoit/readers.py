# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which VTK class reads a file, by the file's extension. Names of the VTK that runs decide."""

import importlib

from .lookup import LazyTable

# Extension: candidates "module:class", best first; those that this VTK lacks are passed over.
# Modules are those of Debian's VTK; a class that moved to another module stands with both.
_TABLE = {
    # VTK's own
    "vtk": ["vtkIOLegacy:vtkGenericDataObjectReader"],
    "pvtk": ["vtkIOParallel:vtkPDataSetReader"],
    "vtp": ["vtkIOXML:vtkXMLPolyDataReader"],
    "vtu": ["vtkIOXML:vtkXMLUnstructuredGridReader"],
    "vti": ["vtkIOXML:vtkXMLImageDataReader"],
    "vtr": ["vtkIOXML:vtkXMLRectilinearGridReader"],
    "vts": ["vtkIOXML:vtkXMLStructuredGridReader"],
    "pvtp": ["vtkIOXML:vtkXMLPPolyDataReader"],
    "pvtu": ["vtkIOXML:vtkXMLPUnstructuredGridReader"],
    "pvti": ["vtkIOXML:vtkXMLPImageDataReader"],
    "pvtr": ["vtkIOXML:vtkXMLPRectilinearGridReader"],
    "pvts": ["vtkIOXML:vtkXMLPStructuredGridReader"],
    "vtm": ["vtkIOXML:vtkXMLMultiBlockDataReader"],
    "vtmb": ["vtkIOXML:vtkXMLMultiBlockDataReader"],
    "vtpd": ["vtkIOXML:vtkXMLPartitionedDataSetReader"],
    "vtpc": ["vtkIOXML:vtkXMLPartitionedDataSetCollectionReader"],
    "vth": ["vtkIOXML:vtkXMLUniformGridAMRReader"],
    "vthb": ["vtkIOXML:vtkXMLUniformGridAMRReader"],
    "htg": ["vtkIOXML:vtkXMLHyperTreeGridReader"],
    "vtkhdf": ["vtkIOHDF:vtkHDFReader"],
    "hdf": ["vtkIOHDF:vtkHDFReader"],
    # meshes
    "stl": ["vtkIOGeometry:vtkSTLReader"],
    "ply": ["vtkIOPLY:vtkPLYReader"],
    "obj": ["vtkIOGeometry:vtkOBJReader"],
    "off": ["vtkIOGeometry:vtkOFFReader"],
    "gltf": ["vtkIOGeometry:vtkGLTFReader"],
    "glb": ["vtkIOGeometry:vtkGLTFReader"],
    "byu": ["vtkIOGeometry:vtkBYUReader"],
    "g": ["vtkIOExodus:vtkExodusIIReader", "vtkIOGeometry:vtkBYUReader"],
    "tri": ["vtkIOGeometry:vtkMCubesReader"],
    "facet": ["vtkFiltersHybrid:vtkFacetReader"],
    "pts": ["vtkIOGeometry:vtkPTSReader"],
    "gml": ["vtkIOCityGML:vtkCityGMLReader"],
    # simulations
    "ex2": ["vtkIOExodus:vtkExodusIIReader", "vtkIOIOSS:vtkIOSSReader"],
    "exo": ["vtkIOExodus:vtkExodusIIReader", "vtkIOIOSS:vtkIOSSReader"],
    "exii": ["vtkIOExodus:vtkExodusIIReader", "vtkIOIOSS:vtkIOSSReader"],
    "e": ["vtkIOExodus:vtkExodusIIReader", "vtkIOIOSS:vtkIOSSReader"],
    "foam": ["vtkIOGeometry:vtkOpenFOAMReader"],
    "cgns": ["vtkIOCGNSReader:vtkCGNSReader"],
    "case": ["vtkIOEnSight:vtkGenericEnSightReader"],
    "encas": ["vtkIOEnSight:vtkGenericEnSightReader"],
    "cas": ["vtkIOGeometry:vtkFLUENTReader"],
    "neu": ["vtkIOGeometry:vtkGAMBITReader"],
    "inp": ["vtkIOGeometry:vtkAVSucdReader"],
    "avs": ["vtkIOGeometry:vtkAVSucdReader"],
    "ucd": ["vtkIOGeometry:vtkAVSucdReader"],
    "tec": ["vtkIOGeometry:vtkTecplotReader"],
    "plt": ["vtkIOGeometry:vtkTecplotReader"],
    "p3d": ["vtkIOParallel:vtkPlot3DMetaReader"],
    "mfix": ["vtkIOGeometry:vtkMFIXReader"],
    "k": ["vtkIOLSDyna:vtkLSDynaReader"],
    "lsdyna": ["vtkIOLSDyna:vtkLSDynaReader"],
    "nc": ["vtkIONetCDF:vtkNetCDFCFReader"],
    "segy": ["vtkIOSegY:vtkSegYReader"],
    "sgy": ["vtkIOSegY:vtkSegYReader"],
    "xdmf": ["vtkIOXdmf2:vtkXdmfReader", "vtkIOXdmf3:vtkXdmf3Reader"],
    "xmf": ["vtkIOXdmf2:vtkXdmfReader", "vtkIOXdmf3:vtkXdmf3Reader"],
    # volumes and pictures
    "mhd": ["vtkIOImage:vtkMetaImageReader"],
    "mha": ["vtkIOImage:vtkMetaImageReader"],
    "nrrd": ["vtkIOImage:vtkNrrdReader"],
    "nhdr": ["vtkIOImage:vtkNrrdReader"],
    "nii": ["vtkIOImage:vtkNIFTIImageReader"],
    "nii.gz": ["vtkIOImage:vtkNIFTIImageReader"],
    "img": ["vtkIOImage:vtkNIFTIImageReader"],
    "hdr": ["vtkIOImage:vtkNIFTIImageReader"],
    "mrc": ["vtkIOImage:vtkMRCReader"],
    "map": ["vtkIOImage:vtkMRCReader"],
    "ccp4": ["vtkIOImage:vtkMRCReader"],
    "mnc": ["vtkIOMINC:vtkMINCImageReader"],
    "slc": ["vtkIOImage:vtkSLCReader"],
    "dem": ["vtkIOImage:vtkDEMReader"],
    "dcm": ["vtkIOImage:vtkDICOMImageReader"],
    "dicom": ["vtkIOImage:vtkDICOMImageReader"],
    "cube": ["vtkIOChemistry:vtkGaussianCubeReader"],
    "tif": ["vtkIOImage:vtkTIFFReader"],
    "tiff": ["vtkIOImage:vtkTIFFReader"],
    "png": ["vtkIOImage:vtkPNGReader"],
    "jpg": ["vtkIOImage:vtkJPEGReader"],
    "jpeg": ["vtkIOImage:vtkJPEGReader"],
    "bmp": ["vtkIOImage:vtkBMPReader"],
    "pnm": ["vtkIOImage:vtkPNMReader"],
    "pgm": ["vtkIOImage:vtkPNMReader"],
    "ppm": ["vtkIOImage:vtkPNMReader"],
}

# Several files of one of these make one volume, a file each slice.
STACKS = frozenset(["tif", "tiff", "png", "jpg", "jpeg", "bmp", "pnm", "pgm", "ppm"])


def _find(candidates):
    for candidate in candidates:
        module_name, class_name = candidate.split(":")
        try:
            module = importlib.import_module("vtkmodules." + module_name)
        except ImportError:
            continue
        if hasattr(module, class_name):
            return getattr(module, class_name)
    return None


_readers = LazyTable(_TABLE, _find)


def reader_class(extension):
    """The VTK reader class for an extension (str, lower case, no dot), None when there is none."""
    return _readers.get(extension)


def extensions():
    """All extensions that the VTK in use has a reader for, sorted list of str."""
    return sorted(extension for extension in _TABLE if _readers.get(extension))


def extension_of(path):
    """The extension of a file's name: lower case, no dot, nii.gz in one; empty without one."""
    parts = str(path).replace("\\", "/").rsplit("/", 1)[-1].lower().split(".")
    if len(parts) > 2 and ".".join(parts[-2:]) in _TABLE:
        return ".".join(parts[-2:])
    # Exodus writes name.ex2.000, name.e.4.0 for the parts of one model.
    while len(parts) > 2 and parts[-1].isdigit():
        parts.pop()
    return parts[-1] if len(parts) > 1 else ""
