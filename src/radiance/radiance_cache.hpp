// Soft light on surfaces, remembered where it fell: what sky, lamps with area and other surfaces send to a point from all
// around, as means over cells in the space of the thing that is lit, so that every pixel, view and frame adds to it and looks
// it up.
//
// Based on: N. Binder et al., "Fast Path Space Filtering by Jittered Spatial Hashing", SIGGRAPH Talks 2018 (cells found by
// hashing); W. James, C. Stein, "Estimation with Quadratic Loss", 1961 (a mean of few samples is drawn towards one of many).
//
// A point has cells of several sizes, each twice as wide as the last. Small ones are sharp and noisy, large ones the reverse;
// resolve() draws each towards the next larger one as far as its own samples do not speak against it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "device/lanes.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

/// A point of a surface, for the cache.
struct CachePoint {
  Vec3f position{0.0f};     ///< moves with the thing: in its own space, world units long
  std::uint32_t thing = 0;  ///< surfaces that never share light: other instances, other sides
  std::uint32_t part = 0;   ///< parts of it that hang together; only large cells hold several
  float size = 1.0f;        ///< > 0: edge that the smallest cell should have
};

/// Light that arrived at a place along one path: per albedo, as radiance that a white surface would send on.
struct RadianceRecord {
  CachePoint place;
  Vec3f light{0.0f};
  /// CachePoint::thing of surfaces that the place's own goes smoothly over into near by: their cells learn from it, too. 0:
  /// none.
  std::array<std::uint32_t, 2> also{};
  /// Luminance of that part of `light` which has been scattered as often as paths may be; < 0: not known, as the path has ended
  /// in the cache.
  float deepest = -1.0f;
  /// What has moved since the frame before may have changed so much of it: luminance that lamps and the sky would bring along
  /// shadow rays that pass it, were they free, and the share of the light that comes along other rays that pass it. Where the
  /// place itself has moved: luminance that they send there by Lambert's law, less what they sent to where it was, and the
  /// share by which cosines of other rays have changed.
  float changed_light = 0.0f, changed_share = 0.0f;
};

/// Places side by side, for RadianceCache::pick.
struct CacheQueries {
  LaneMask active{};
  Lanes3 position{};
  alignas(64) std::uint32_t thing[kLanes]{}, part[kLanes]{};
  Lanes size{};     ///< these four: CachePoint's
  Lanes3 normal{};  ///< normal of the surface, in the place's space, unit length
  Lanes u{}, v{};   ///< random numbers in [0, 1)

  void set(int i, const CachePoint& place, Vec3f of_surface, Vec2f random) {
    active.lane[i] = -1;
    position.set(i, place.position);
    thing[i] = place.thing, part[i] = place.part;
    size[i] = place.size;
    normal.set(i, of_surface);
    u[i] = random.x, v[i] = random.y;
  }
  CachePoint place(int i) const { return {position.get(i), thing[i], part[i], size[i]}; }
};

/// Where light changes by so much beyond what cells follow, in sRGB's codes (0 ... 1), it is left to paths: nowhere, from 0.2
/// on, from 0.1, from 0.05.
enum class EdgesToPaths : std::uint8_t { kNone, kStrong, kVisible, kFaint };
inline EdgesToPaths more_edges(EdgesToPaths than) {
  return than == EdgesToPaths::kFaint ? than : static_cast<EdgesToPaths>(static_cast<int>(than) + 1);
}
inline EdgesToPaths fewer_edges(EdgesToPaths than) {
  return than == EdgesToPaths::kNone ? than : static_cast<EdgesToPaths>(static_cast<int>(than) - 1);
}

/// What of a place's light is looked up: all of it, or, for paths on whose way a surface more has scattered it, all but what
/// was scattered as often as paths may be.
enum class LookedUp : std::uint8_t { kAll, kWithoutDeepest };

class RadianceCache {
 public:
  static constexpr int kLevels = 4;
  static constexpr std::size_t kShards = 64;  ///< filled side by side, whatever the number of threads

  /// Holds at most about so many cells. Where there is no room for a new one, larger ones or paths of its own serve a place.
  explicit RadianceCache(std::size_t most_cells);

  /// World units by which a point of a thing (CachePoint) has moved since the frame before.
  using Motion = std::function<float(std::uint32_t thing, Vec3f position)>;

  /// What was added so far becomes the past. It is forgotten where things have moved, as far as light differs over such a
  /// distance.
  void begin_frame(const Motion& moved, const ThreadPool& pool);

  /// Adds records, in this order whatever the threads.
  void add(std::span<const std::span<const RadianceRecord>> records, const ThreadPool& pool);

  /// Forgets the past as far as what was added in this frame asks for: where both contradict each other by more than chance
  /// explains, and where what moves may have changed the light (RadianceRecord). May be called again when more has been added.
  /// Returns the share of all that was known when the frame began, 0 ... 1, that is forgotten.
  float forget(const ThreadPool& pool);

  /// Makes what look_up() and pick() give from what was added: cells that are new since the last time are not known to them.
  void resolve(const ThreadPool& pool);
  bool is_resolved() const { return is_resolved_; }  ///< at least once

  /// The light at a place, interpolated, and in `w` how well that place is known: 0 not at all.
  Vec4f look_up(const CachePoint& place) const;

  /// The same at the active lanes' places, left to chance: of the cells that it is interpolated from, one. Returns the lanes
  /// whose light is known and belongs to none of the edges that are left to paths, and sets `light` there.
  LaneMask pick(const CacheQueries& queries, EdgesToPaths edges, LookedUp what, Lanes3& light) const;

  /// How many samples the smallest cell there has.
  float samples(const CachePoint& place) const;

  /// How much of what is known there comes from frames before, 0 ... 1.
  float share_of_past(const CachePoint& place) const;

  std::size_t cells() const;
  std::size_t bytes() const;
  /// What a cell takes in a full cache.
  static std::size_t bytes_per_cell();

 private:
  /// What is told of a sample to all cells that it belongs to.
  struct Sample {
    explicit Sample(Vec3f light);
    Vec3f light;
    float luminance, root;  ///< root: the fourth root of the luminance
  };
  /// Sums over samples. Kept as means, so that long histories lose no digits.
  struct Moments {
    Vec3f mean{0.0f};
    float square = 0.0f;  ///< mean of the squared luminance
    /// Mean of the fourth root of the luminance, and of its square: a single bright sample moves them little, so that means of
    /// few samples can be compared.
    float root = 0.0f, root_square = 0.0f;
    float count = 0.0f;
    void add(const Sample& sample);
    void add(const Moments& more);
    float variance() const;       ///< how one sample's luminance varies
    float root_variance() const;  ///< how its fourth root varies
  };
  /// As RadianceRecord has it.
  struct PossibleChange {
    float light = 0.0f, share = 0.0f;
  };
  /// Squared deviations: of the luminance, and of its fourth root.
  struct Scatter {
    float light = 0.0f, root = 0.0f;
  };
  /// How light changes across a cell, beyond what changes evenly: the fewest edges that this belongs to, kNone for none.
  struct Bend {
    EdgesToPaths seen = EdgesToPaths::kNone;  ///< chance may explain it
    EdgesToPaths sure = EdgesToPaths::kNone;
  };
  struct Cell {
    Vec3f center;
    std::uint32_t thing, part;
    int exponent;              ///< edge 2^exponent
    std::uint32_t around = 0;  ///< the larger cell around it: kShards x index + shard, or kNothing; of link_parents()
    // What records are added to, side by side.
    Moments now;
    float samples_ever = 0.0f;
    PossibleChange possible_change_now;  ///< mean of what `now` holds
    /// Of all records that tell (RadianceRecord::deepest), ever: sums of luminance, and of what is deepest of it.
    float told = 0.0f, deepest = 0.0f;
    Moments past;
    float inherited = 0.0f;          ///< samples of the past before forget()
    PossibleChange possible_change;  ///< that of `now`, with what larger cells say of it
    // What neighbours and cells within ask for, side by side.
    float samples = 0.0f;
    float luminance = 0.0f;  ///< the luminance of `own`
    Scatter scatter;         ///< scatter of one sample
    float root = 0.0f;       ///< mean fourth root of the luminance, of few samples drawn to that of the larger cell
    Scatter relative;        ///< the same over the cell's level
    Scatter within;          ///< and the scatter of one sample about the mean of its cell, in the cells within this one
    float variance = 0.0f;   ///< the variance of the resolved value's luminance
    float keep = 1.0f;       ///< the share of the past that is kept
    Vec3f own{0.0f};         ///< mean of its own samples
    Vec3f wider{0.0f};       ///< what larger cells say of it
    bool has_wider = false;
    float drawn = 0.0f;          ///< towards that, 0 ... 1
    Vec3f shift{0.0f};           ///< what it was resolved to, less its own
    Vec3f balance{0.0f};         ///< what cells within it are given back, as far as they are drawn
    float spread = 0.0f;         ///< squared luminance by which cells within this one differ from what it says of them
    float relief = 0.0f;         ///< and from its mean
    float deepest_share = 0.0f;  ///< a slot's
    Bend bend;
    EdgesToPaths edge = EdgesToPaths::kNone;  ///< as a slot has it
  };
  /// Open addressing; what look_up() asks for lies in the slot itself.
  static constexpr std::uint32_t kMostCells = (1u << 28) - 1u;  ///< of a shard
  struct Slot {
    std::uint64_t key = 0;  ///< 0: empty
    Vec3f light{0.0f};
    float deepest_share = 0.0f;  ///< the share of it that LookedUp leaves out
    std::uint32_t cell : 28 = 0;
    std::uint32_t is_resolved : 1 = 0;
    std::uint32_t ends_paths : 1 = 0;  ///< enough samples are known
    std::uint32_t edge : 2 = 0;        ///< EdgesToPaths: the fewest that it belongs to, 0 for none
    bool is_in(EdgesToPaths edges) const { return edge != 0 && edge <= static_cast<std::uint32_t>(edges); }
  };
  struct Shard {
    std::vector<Slot> slots;
    std::vector<Cell> cells;
    const Slot* find(std::uint64_t key) const;
    void prefetch(std::uint64_t key) const {
      if (!slots.empty()) __builtin_prefetch(&slots[key & (slots.size() - 1)]);
    }
    Cell* find_or_add(std::uint64_t key, std::size_t most_cells, bool& is_new);
    void reserve(std::size_t cells);
    void put(const Slot& slot);
  };

  struct Target;
  struct Targets;
  static void find_targets(std::span<const RadianceRecord> records, Targets& targets);
  static void add_to_cell(Cell& cell, const Sample& sample, const RadianceRecord& record);
  void add_to_shard(Shard& shard, std::span<const Target> targets, std::span<const Sample> samples,
                    std::span<const RadianceRecord> records);
  void prefetch(std::uint64_t key) const;
  const Slot* find(std::uint64_t key) const;
  void find_all(const std::uint64_t* keys, EdgesToPaths edges, LookedUp what, LaneMask& left, LaneMask& known,
                Lanes3& light) const;
  const Cell* cell_of(std::uint64_t key) const;
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  std::uint32_t find_parent(const Cell& cell) const;
  void link_parents(const ThreadPool& pool);
  const Cell* parent_of(const Cell& cell) const {
    return cell.around == kNothing ? nullptr : &shards_[cell.around % kShards].cells[cell.around / kShards];
  }
  static float contradicted(const Cell& cell);
  static float possibly_changed(const Cell& cell, const Cell* parent);
  static float level(const Cell& cell, const Cell* parent);
  static float deepest_share(const Cell& cell, const Cell* parent);
  static float outdated(const Cell& cell, const Cell& parent, float moved);
  struct Interpolated {
    Vec3f sum{0.0f};
    float weight = 0.0f;
    bool inside = false;  ///< the cell around the point itself is known
  };
  Interpolated interpolate(Vec3f p, std::uint64_t base, int exponent) const;
  /// Where a cell and its slot are in a shard.
  struct Place {
    std::uint32_t cell, slot;
  };
  /// By shard, in the order in which cells were added; and by exponent, large cells first.
  using PlacesOfShards = std::array<std::vector<Place>, kShards>;
  using PlacesBySize = std::map<int, PlacesOfShards, std::greater<>>;
  PlacesBySize places_by_size(const ThreadPool& pool) const;
  void for_each_in(std::size_t shard, const PlacesOfShards& places, const auto& fn);
  void for_each_of_size(const ThreadPool& pool, const PlacesOfShards& places, const auto& fn);
  void sum_into_parents(const PlacesOfShards& places, const PlacesOfShards& parents, const ThreadPool& pool,
                        const auto& of_cell, const auto& use);
  void find_scatter(const PlacesOfShards& places, const PlacesOfShards* wider, const ThreadPool& pool);
  void compare_with_wider(Cell& cell) const;
  void find_spreads(const PlacesOfShards& places, const PlacesOfShards& wider, const ThreadPool& pool);
  void resolve(Cell& cell, Slot& slot) const;
  static Bend bend(const Cell& cell, const Cell& before, const Cell& after);
  void find_bends(std::span<Cell* const> cells) const;
  void find_edges(const PlacesBySize& by_size, const ThreadPool& pool);
  void balance(const PlacesOfShards& places, const PlacesOfShards& wider, const ThreadPool& pool);

  std::vector<Shard> shards_;
  std::size_t most_cells_;  ///< how many a shard may have
  bool is_resolved_ = false;
  bool are_linked_ = false;  ///< Cell::around is as it would be found now
};

/// fn(cell, slot) for every cell of a size in a shard. Slots and parents lie anywhere in memory, which is asked for them ahead.
void RadianceCache::for_each_in(std::size_t shard, const PlacesOfShards& places, const auto& fn) {
  constexpr std::size_t kAhead = 8;
  Shard& in = shards_[shard];
  const std::vector<Place>& all = places[shard];
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + kAhead < all.size()) {
      __builtin_prefetch(&in.slots[all[i + kAhead].slot]);
      if (const Cell* const parent = parent_of(in.cells[all[i + kAhead].cell])) __builtin_prefetch(&parent->samples);
    }
    fn(in.cells[all[i].cell], in.slots[all[i].slot]);
  }
}

/// The same for all shards, side by side.
void RadianceCache::for_each_of_size(const ThreadPool& pool, const PlacesOfShards& places, const auto& fn) {
  pool.for_each(kShards, [&](std::size_t s) { for_each_in(s, places, fn); });
}

}  // namespace lippmann
