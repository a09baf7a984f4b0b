#include "radiosity/refine.h"

#include <algorithm>
#include <span>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "radiosity/oracle.h"

namespace gg {

namespace {

// Appends links, whose hits are first_hit.. of `hits`.
void append(Links& to, std::span<const Link> links, const NearHits& hits) {
    for (Link link : links) {
        if (link.near) {
            const auto begin = hits.begin() + link.first_hit;
            link.first_hit = static_cast<std::uint32_t>(to.hits.size());
            to.hits.insert(to.hits.end(), begin, begin + link.hit_count);
        }
        to.all.push_back(link);
    }
}

struct Pair {
    NodeId receiver, sender;
};

struct Round {
    Links accepted;
    std::vector<Pair> open_pairs;
    std::vector<Verdict> verdicts;  // of open_pairs
};

Round judge(const Hierarchy& hierarchy, const Lighting& lighting, const RayTracer& tracer,
            const std::vector<Pair>& pairs, const RefineSettings& settings, const Control& control) {
    constexpr std::size_t kBlock = 32;
    const std::size_t blocks = (pairs.size() + kBlock - 1) / kBlock;
    std::vector<Round> parts(blocks);
    parallel_blocks(pairs.size(), kBlock, control, [&](std::size_t begin, std::size_t end) {
        Round& part = parts[begin / kBlock];
        for (std::size_t i = begin; i < end; ++i) {
            const Decision decision =
                decide(hierarchy, lighting, tracer, pairs[i].receiver, pairs[i].sender, settings, part.accepted.hits);
            if (decision.verdict == Verdict::kAccept) {
                part.accepted.all.push_back(decision.link);
            } else if (decision.verdict != Verdict::kDrop) {
                part.open_pairs.push_back(pairs[i]);
                part.verdicts.push_back(decision.verdict);
            }
        }
    });
    Round all;
    for (const Round& part : parts) {
        append(all.accepted, part.accepted.all, part.accepted.hits);
        all.open_pairs.insert(all.open_pairs.end(), part.open_pairs.begin(), part.open_pairs.end());
        all.verdicts.insert(all.verdicts.end(), part.verdicts.begin(), part.verdicts.end());
    }
    return all;
}

NodeId node_to_open(const Pair& pair, Verdict verdict) {
    return verdict == Verdict::kSplitSender ? pair.sender : pair.receiver;
}

void open_nodes(Hierarchy& hierarchy, Lighting& lighting, const Round& round, const Control& control) {
    std::vector<NodeId> leaves;
    for (std::size_t i = 0; i < round.open_pairs.size(); ++i) {
        const NodeId id = node_to_open(round.open_pairs[i], round.verdicts[i]);
        if (hierarchy[id].child_count == 0) {
            leaves.push_back(id);
        }
    }
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    hierarchy.open(leaves, control);
    lighting.grow(control);
}

std::vector<Pair> pairs_of_children(const Hierarchy& hierarchy, const Round& round) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < round.open_pairs.size(); ++i) {
        const Pair pair = round.open_pairs[i];
        const Node& opened = hierarchy[node_to_open(pair, round.verdicts[i])];
        for (NodeId child = opened.first_child; child < opened.first_child + opened.child_count; ++child) {
            if (round.verdicts[i] == Verdict::kSplitSelf) {
                for (NodeId other = opened.first_child; other < opened.first_child + opened.child_count; ++other) {
                    pairs.push_back({child, other});
                }
            } else if (round.verdicts[i] == Verdict::kSplitSender) {
                pairs.push_back({pair.receiver, child});
            } else {
                pairs.push_back({child, pair.sender});
            }
        }
    }
    return pairs;
}

}  // namespace

Links initial_links(const Hierarchy& hierarchy) {
    Links links;
    if (!hierarchy.has_geometry()) {
        return links;
    }
    Link link;
    link.level_error = kInfinity;  // never judged
    links.all.push_back(link);
    for (const NodeId sender : hierarchy.infinite_and_lamps()) {
        link.sender = sender;
        links.all.push_back(link);
    }
    return links;
}

void refine(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer, Links& links,
            const RefineSettings& settings, const Control& control, Statistics& statistics) {
    Links kept;
    std::vector<Pair> pairs;
    for (const Link& link : links.all) {
        if (still_good(hierarchy, lighting, link, settings) && !may_be_uneven(hierarchy, lighting, link, settings)) {
            append(kept, {&link, 1}, links.hits);
        } else {
            pairs.push_back({link.receiver, link.sender});
        }
    }
    links = {};
    std::size_t judged = 0;
    while (!pairs.empty()) {
        judged += pairs.size();
        const Round round = judge(hierarchy, lighting, tracer, pairs, settings, control);
        append(kept, round.accepted.all, round.accepted.hits);
        open_nodes(hierarchy, lighting, round, control);
        pairs = pairs_of_children(hierarchy, round);
    }
    links = std::move(kept);
    statistics.set_count("pairs judged", static_cast<double>(judged));
}

}  // namespace gg
