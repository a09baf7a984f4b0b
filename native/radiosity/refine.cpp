#include "radiosity/refine.h"

#include <algorithm>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "radiosity/oracle.h"

namespace gg {

namespace {

struct Pair {
    NodeId receiver, sender;
};

struct Round {
    std::vector<Link> accepted;
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
            const Decision decision = decide(hierarchy, lighting, tracer, pairs[i].receiver, pairs[i].sender, settings);
            if (decision.verdict == Verdict::kAccept) {
                part.accepted.push_back(decision.link);
            } else if (decision.verdict != Verdict::kDrop) {
                part.open_pairs.push_back(pairs[i]);
                part.verdicts.push_back(decision.verdict);
            }
        }
    });
    Round all;
    for (const Round& part : parts) {
        all.accepted.insert(all.accepted.end(), part.accepted.begin(), part.accepted.end());
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

std::vector<Link> initial_links(const Hierarchy& hierarchy) {
    std::vector<Link> links;
    if (!hierarchy.has_geometry()) {
        return links;
    }
    Link link;
    link.level_error = kInfinity;  // never judged
    links.push_back(link);
    for (const NodeId sender : hierarchy.infinite_and_lamps()) {
        link.sender = sender;
        links.push_back(link);
    }
    return links;
}

std::vector<Link> refine(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer, std::vector<Link> links,
                         const RefineSettings& settings, const Control& control, Statistics& statistics) {
    std::vector<Link> kept;
    std::vector<Pair> pairs;
    for (const Link& link : links) {
        if (still_good(hierarchy, lighting, link, settings)) {
            kept.push_back(link);
        } else {
            pairs.push_back({link.receiver, link.sender});
        }
    }
    std::vector<Link>().swap(links);
    std::size_t judged = 0;
    while (!pairs.empty()) {
        judged += pairs.size();
        Round round = judge(hierarchy, lighting, tracer, pairs, settings, control);
        kept.insert(kept.end(), round.accepted.begin(), round.accepted.end());
        open_nodes(hierarchy, lighting, round, control);
        pairs = pairs_of_children(hierarchy, round);
    }
    statistics.set_count("pairs judged", static_cast<double>(judged));
    return kept;
}

}  // namespace gg
