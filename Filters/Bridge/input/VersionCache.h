// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_VersionCache_h
#define geodesic_bridge_VersionCache_h

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace geodesic::bridge
{

/**
 * Finds an object again that was made from an input, by the input's version, for as long as
 * somebody holds the object. Safe to use from several threads; only one of them makes an object at
 * a time.
 */
template <class Version, class Made>
class VersionCache
{
public:
  /** Returns the object that was made for a version, or else the result of @p make. */
  template <class Make>
  std::shared_ptr<Made> get(Version version, const Make& make)
  {
    const std::lock_guard lock(this->Mutex);
    std::erase_if(this->Known, [](const auto& known) { return known.second.expired(); });
    for (const auto& [knownVersion, kept] : this->Known)
    {
      const auto made = kept.lock();
      if (made && knownVersion == version)
      {
        return made;
      }
    }
    std::shared_ptr<Made> made = make();
    this->Known.emplace_back(std::move(version), made);
    return made;
  }

private:
  std::mutex Mutex;
  std::vector<std::pair<Version, std::weak_ptr<Made>>> Known;
};

}

#endif
