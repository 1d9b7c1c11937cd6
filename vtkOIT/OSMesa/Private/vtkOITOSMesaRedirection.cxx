// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/vtkOITOSMesaRedirection.h"

#include "Private/vtkOITOSMesaLibrary.h"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>

namespace
{
using Function = vtkOITOSMesaLibrary::Function;

// ELF's types, of 32 or 64 bits.
using Address = ElfW(Addr);
using Entry = ElfW(Dyn);
using Header = ElfW(Phdr);
using RelocationWithAddend = ElfW(Rela);
using RelocationWithoutAddend = ElfW(Rel);
using Symbol = ElfW(Sym);

//------------------------------------------------------------------------------
// What GLEW asks of GLX. It wants a display that is not null and never looks into it.
int DisplayStandIn;

void* GetCurrentDisplay()
{
  return &DisplayStandIn;
}

Function GetProcAddress(const unsigned char* name)
{
  const char* text = reinterpret_cast<const char*>(name);
  return std::strcmp(text, "glXGetCurrentDisplay") == 0
    ? reinterpret_cast<Function>(&GetCurrentDisplay)
    : vtkOITOSMesaLibrary::Get().GetProcAddress(text);
}

int QueryVersion(void*, int* major, int* minor)
{
  *major = 1;
  *minor = 4;
  return 1;
}

const char* GetClientString(void*, int)
{
  return "";
}

struct StandIn
{
  const char* Name;
  Function Replacement;
};

const StandIn StandIns[] = {
  { "glXGetClientString", reinterpret_cast<Function>(&GetClientString) },
  { "glXGetCurrentDisplay", reinterpret_cast<Function>(&GetCurrentDisplay) },
  { "glXGetProcAddress", reinterpret_cast<Function>(&GetProcAddress) },
  { "glXGetProcAddressARB", reinterpret_cast<Function>(&GetProcAddress) },
  { "glXQueryVersion", reinterpret_cast<Function>(&QueryVersion) },
};

//------------------------------------------------------------------------------
// The function to call instead of the one of this name; null to leave the call as it is.
Function GetReplacement(const char* name)
{
  // OpenGL's names only: libraries have ten thousands of others.
  if (name[0] != 'g' || name[1] != 'l' || name[2] < 'A' || name[2] > 'Z')
  {
    return nullptr;
  }
  if (name[2] != 'X')
  {
    return vtkOITOSMesaLibrary::Get().GetProcAddress(name);
  }
  for (const StandIn& standIn : StandIns)
  {
    if (std::strcmp(name, standIn.Name) == 0)
    {
      return standIn.Replacement;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool IsVTKOrGLEW(const char* path)
{
  const char* slash = std::strrchr(path, '/');
  const char* file = slash ? slash + 1 : path;
  return std::strncmp(file, "libvtk", 6) == 0 || std::strncmp(file, "libGLEW", 7) == 0;
}

//------------------------------------------------------------------------------
template <typename Relocation>
unsigned long GetSymbolIndex(const Relocation& relocation)
{
#if __ELF_NATIVE_CLASS == 64
  return ELF64_R_SYM(relocation.r_info);
#else
  return ELF32_R_SYM(relocation.r_info);
#endif
}

//------------------------------------------------------------------------------
// A table of relocations: DT_JMPREL, DT_RELA or DT_REL.
struct Table
{
  Address Start = 0;
  size_t Size = 0;
};

//------------------------------------------------------------------------------
// One loaded executable or library.
class LoadedObject
{
public:
  explicit LoadedObject(const dl_phdr_info& info)
    : Base(info.dlpi_addr)
  {
    for (int i = 0; i < info.dlpi_phnum; ++i)
    {
      const Header& header = info.dlpi_phdr[i];
      if (header.p_type == PT_DYNAMIC)
      {
        this->Dynamic = reinterpret_cast<const Entry*>(this->Base + header.p_vaddr);
      }
      else if (header.p_type == PT_GNU_RELRO)
      {
        const Address page = static_cast<Address>(sysconf(_SC_PAGESIZE));
        const Address start = this->Base + header.p_vaddr;
        this->ReadOnlyStart = start & ~(page - 1);
        this->ReadOnlyEnd = (start + header.p_memsz) & ~(page - 1);
      }
    }
    if (this->Dynamic)
    {
      this->ReadDynamic();
    }
  }

  bool UsesVTK(const char* path) const
  {
    if (!this->Strings || !this->Symbols)
    {
      return false;
    }
    if (IsVTKOrGLEW(path))
    {
      return true;
    }
    for (const Entry* entry = this->Dynamic; entry->d_tag != DT_NULL; ++entry)
    {
      if ((entry->d_tag == DT_NEEDED || entry->d_tag == DT_SONAME) &&
        IsVTKOrGLEW(this->Strings + entry->d_un.d_val))
      {
        return true;
      }
    }
    return false;
  }

  // False, with errno set, when the system does not allow it.
  bool Redirect()
  {
    return this->RedirectTable<RelocationWithAddend>(this->WithAddend) &&
      this->RedirectTable<RelocationWithoutAddend>(this->WithoutAddend) &&
      (this->CallsHaveAddend ? this->RedirectTable<RelocationWithAddend>(this->Calls)
                             : this->RedirectTable<RelocationWithoutAddend>(this->Calls));
  }

private:
  void ReadDynamic()
  {
    for (const Entry* entry = this->Dynamic; entry->d_tag != DT_NULL; ++entry)
    {
      // Some C libraries write absolute addresses into this section, others leave offsets.
      const Address value = entry->d_un.d_ptr;
      const Address address = value < this->Base ? this->Base + value : value;
      switch (entry->d_tag)
      {
        case DT_STRTAB:
          this->Strings = reinterpret_cast<const char*>(address);
          break;
        case DT_SYMTAB:
          this->Symbols = reinterpret_cast<const Symbol*>(address);
          break;
        case DT_JMPREL:
          this->Calls.Start = address;
          break;
        case DT_PLTRELSZ:
          this->Calls.Size = value;
          break;
        case DT_PLTREL:
          this->CallsHaveAddend = value == DT_RELA;
          break;
        case DT_RELA:
          this->WithAddend.Start = address;
          break;
        case DT_RELASZ:
          this->WithAddend.Size = value;
          break;
        case DT_REL:
          this->WithoutAddend.Start = address;
          break;
        case DT_RELSZ:
          this->WithoutAddend.Size = value;
          break;
        default:
          break;
      }
    }
  }

  template <typename Relocation>
  bool RedirectTable(const Table& table)
  {
    const auto* relocations = reinterpret_cast<const Relocation*>(table.Start);
    const size_t count = table.Start ? table.Size / sizeof(Relocation) : 0;
    for (size_t i = 0; i < count; ++i)
    {
      const unsigned long index = GetSymbolIndex(relocations[i]);
      const Symbol& symbol = this->Symbols[index];
      if (index == 0 || symbol.st_shndx != SHN_UNDEF)
      {
        continue;
      }
      if (Function replacement = GetReplacement(this->Strings + symbol.st_name))
      {
        auto* slot = reinterpret_cast<Function*>(this->Base + relocations[i].r_offset);
        if (*slot != replacement && !this->Write(slot, replacement))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool Write(Function* slot, Function value) const
  {
    const Address address = reinterpret_cast<Address>(slot);
    const bool readOnly = address >= this->ReadOnlyStart && address < this->ReadOnlyEnd;
    void* start = reinterpret_cast<void*>(this->ReadOnlyStart);
    const size_t size = this->ReadOnlyEnd - this->ReadOnlyStart;
    if (readOnly && mprotect(start, size, PROT_READ | PROT_WRITE) != 0)
    {
      return false;
    }
    *slot = value;
    return !readOnly || mprotect(start, size, PROT_READ) == 0;
  }

  Address Base;
  const Entry* Dynamic = nullptr;
  const char* Strings = nullptr;
  const Symbol* Symbols = nullptr;
  Table Calls;
  Table WithAddend;
  Table WithoutAddend;
  bool CallsHaveAddend = false;
  Address ReadOnlyStart = 0;
  Address ReadOnlyEnd = 0;
};

//------------------------------------------------------------------------------
struct State
{
  std::mutex Mutex;
  unsigned long long Loaded = 0;
  std::string Error;
};

State& GetState()
{
  static State* state = new State; // never destroyed: a window may end later
  return *state;
}

//------------------------------------------------------------------------------
// The loader's count of objects loaded so far: an unchanged count means nothing to do.
int GetLoaded(dl_phdr_info* info, size_t, void* loaded)
{
  *static_cast<unsigned long long*>(loaded) = info->dlpi_adds;
  return 1;
}

//------------------------------------------------------------------------------
int Treat(dl_phdr_info* info, size_t, void* data)
{
  auto* state = static_cast<State*>(data);
  LoadedObject object(*info);
  if (!object.UsesVTK(info->dlpi_name))
  {
    return 0;
  }
  if (!object.Redirect())
  {
    state->Error = std::string("the OpenGL calls of ") +
      (info->dlpi_name[0] ? info->dlpi_name : "the program") +
      " cannot be redirected to OSMesa: " + std::strerror(errno) +
      "; the system must allow mprotect on loaded libraries";
    return 1;
  }
  return 0;
}
}

//------------------------------------------------------------------------------
std::string vtkOITOSMesaRedirection::Update()
{
  State& state = GetState();
  const std::lock_guard<std::mutex> lock(state.Mutex);
  unsigned long long loaded = 0;
  dl_iterate_phdr(GetLoaded, &loaded);
  if (loaded != state.Loaded)
  {
    state.Error.clear();
    dl_iterate_phdr(Treat, &state);
    state.Loaded = loaded;
  }
  return state.Error;
}
