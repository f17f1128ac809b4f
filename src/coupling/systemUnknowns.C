/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "systemUnknowns.H"
#include "gatherAll.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::labelList> Foam::systemUnknowns::keys() const
{
    List<labelList> key(regions_.size());
    label offset = 0;
    forAll(regions_, r)
    {
        key[r] = regions_[r].layout().keys();
        for (label& k : key[r]) k += offset;
        offset += regions_[r].layout().nKeys();
    }

    // Any number of interfaces may meet at a node: the smallest key of all
    // that are joined stands for them
    Map<label> parent;
    const auto root = [&](label k)
    {
        while (parent.found(k) && parent[k] != k) k = parent[k];
        return k;
    };
    const auto indexOf = [&](const feRegion& region)
    {
        label i = 0;
        while (&regions_[i] != &region) ++i;
        return i;
    };
    for (const feInterface& i : interfaces_)
    {
        for (const labelPair& pair : i.joined(key[indexOf(i.leader())], key[indexOf(i.follower())]))
        {
            const label a = root(pair.first()), b = root(pair.second());
            parent.set(max(a, b), min(a, b));
            parent.insert(min(a, b), min(a, b));
        }
    }
    if (!parent.empty()) for (labelList& keys : key) for (label& k : keys) k = root(k);
    return key;
}


void Foam::systemUnknowns::number()
{
    const List<labelList> key(keys());

    // Nodes of this rank
    Map<label> nodeOf;
    DynamicList<label> nodeKeys;
    List<labelList> node(regions_.size());
    forAll(regions_, r)
    {
        node[r].setSize(key[r].size());
        forAll(key[r], e)
        {
            const auto found = nodeOf.cfind(key[r][e]);
            node[r][e] = found.found() ? *found : nodeKeys.size();
            if (found.found()) continue;
            nodeOf.insert(key[r][e], nodeKeys.size());
            nodeKeys.append(key[r][e]);
        }
    }

    // Unknowns of each region at each node beside that of the motion, as any
    // rank knows them
    const label nRegions = regions_.size();
    const nodeMap count(nodeKeys, labelList(nodeKeys.size(), nRegions));
    scalarField further(count.nUnknowns(), 0), motion(further);
    forAll(regions_, r)
    {
        const fieldLayout& layout = regions_[r].layout();
        const labelList n(fieldUnknowns::counts(layout));
        forAll(n, e)
        {
            const bool moves = layout.value(0, e) >= 0;
            const label i = count.start(node[r][e]) + r;
            motion[i] = moves ? layout.nComponents(0) : 0;
            further[i] = n[e] - motion[i];
        }
    }
    count.maximum(further);
    count.maximum(motion);

    // The motion comes first, then the others region by region
    labelList nUnknowns(nodeKeys.size(), 0);
    List<List<labelList>> offset(nRegions);
    forAll(regions_, r) offset[r] = fieldUnknowns::offsets(regions_[r].layout());
    const auto first = [&](const label n, const label region)
    {
        scalar shared = 0, before = 0;
        for (label r = 0; r < nRegions; ++r)
        {
            shared = max(shared, motion[count.start(n) + r]);
            if (r < region) before += further[count.start(n) + r];
        }
        return label(shared + before);
    };
    forAll(nUnknowns, n) nUnknowns[n] = first(n, nRegions);
    forAll(regions_, r)
    {
        const fieldLayout& layout = regions_[r].layout();
        forAll(offset[r], f)
        {
            if (f == 0) continue;
            forAll(offset[r][f], i)
            {
                const label n = node[r][layout.entity(f, i)];
                offset[r][f][i] += first(n, r) - label(motion[count.start(n) + r]);
            }
        }
    }

    map_.reset(new nodeMap(nodeKeys, nUnknowns));
    forAll(regions_, r) regions_[r].number(map_(), node[r], offset[r]);
}


bool Foam::systemUnknowns::constrain()
{
    for (const feRegion& region : regions_) region.constrain(constraints_());
    for (feInterface& i : interfaces_) i.constrain(constraints_());
    return constraints_->close();
}


void Foam::systemUnknowns::makeBlocks()
{
    forAll(regions_, r)
    {
        const fieldLayout& layout = regions_[r].layout();
        for (label f = 0; f < layout.nFields(); ++f)
        {
            blocks_.append({r, f, word(regions_[r].name() + '.' + layout[f].name)});
        }
    }

    // Of a shared unknown the block of the region that leads, as any rank knows
    const scalar leads = blocks_.size();
    scalarField block(map_->nUnknowns(), -1);
    forAll(blocks_, b)
    {
        const feRegion& region = regions_[blocks_[b].region];
        const label f = blocks_[b].field;
        for (label i = 0; i < region.layout().size(f); ++i)
        {
            for (label a = 0; a < region.layout().nComponents(f); ++a)
            {
                scalar& at = block[region.unknowns().start(f, i) + a];
                at = max(at, b + (region.leads() ? leads : 0));
            }
        }
    }
    map_->maximum(block);
    blockOf_.setSize(block.size());
    forAll(block, u) blockOf_[u] = max(label(block[u]), 0) % blocks_.size();
}


void Foam::systemUnknowns::reportHeld(const feInterface& interface) const
{
    // As any rank knows, at the first unknown of a node
    const feRegion &follower = interface.follower(), &leader = interface.leader();
    scalarField byFollower(map_->nUnknowns(), 0), byLeader(byFollower);
    const labelList nodes(interface.followerNodes());
    for (const label n : nodes) byFollower[follower.unknowns().start(0, n)] = follower.boundary().constrained(n);
    for (label n = 0; n < leader.fe().nNodes(); ++n)
    {
        byLeader[leader.unknowns().start(0, n)] = leader.boundary().constrained(n);
    }
    map_->maximum(byFollower);
    map_->maximum(byLeader);

    // By the leader's node that it is, or by one that it is tied to
    const auto heldByLeader = [&](const label u)
    {
        if (interface.sharesNodes() || !constraints_->isTied(u)) return byLeader[u] > 0;
        for (const auto& t : constraints_->masters(u))
        {
            if (byLeader[map_->start(map_->nodeOf(t.unknown))] > 0) return true;
        }
        return false;
    };

    label n = 0;
    point where = point::max;
    wordList names;
    for (const label node : nodes)
    {
        const label u = follower.unknowns().start(0, node);
        if (byFollower[u] == 0 || heldByLeader(u) || !map_->owned(follower.unknowns().node(node))) continue;
        ++n;
        where = follower.fe().points()[node];
        if (follower.boundary().constrained(node)) names.append(follower.boundary().patchName(node));
    }
    const wordList all(wordHashSet(gatherAll<word>(names)).sortedToc());
    reduce(where, minOp<point>());
    if (!returnReduce(n, sumOp<label>())) return;
    WarningInFunction
        << "Interface " << interface.name() << ": " << returnReduce(n, sumOp<label>())
        << " of its nodes, one at " << where << ", are also on patches " << all << " of region "
        << follower.name() << " with conditions there; " << leader.name() << " is free at them." << nl
        << (
               interface.sharesNodes()
             ? "    Values of these patches do not count at the interface's nodes, planes of"
               " symmetry and slip do."
             : "    These do not count at the interface's nodes: where they should, give"
               " the region that leads the same conditions."
           )
        << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::systemUnknowns::systemUnknowns
(
    PtrList<feRegion>& regions,
    PtrList<feInterface>& interfaces
)
:
    regions_(regions),
    interfaces_(interfaces)
{
    number();
    constraints_.reset(new dofConstraints(map_()));
    constrain();
    makeBlocks();
    for (const feInterface& i : interfaces_) reportHeld(i);
    for (feRegion& region : regions_) region.connect();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::systemUnknowns::renewConstraints()
{
    bool move = false;
    for (const feRegion& region : regions_) move = move || region.constraintsMove();
    if (!move) return;
    constraints_->reopen();
    if (constrain()) return;
    FatalErrorInFunction
        << "The constraints join other unknowns than at the start" << abort(FatalError);
}


Foam::label Foam::systemUnknowns::nFree() const
{
    label n = 0;
    for (const label u : map_->ownedUnknowns()) if (constraints_->isFree(u)) ++n;
    return returnReduce(n, sumOp<label>());
}


Foam::string Foam::systemUnknowns::describe(const label global, label& block) const
{
    // The owner knows it, at a node of one of its regions
    string what;
    block = -1;
    const label u = global >= 0 ? map_->local(global) : -1;
    if (u >= 0 && map_->owned(map_->nodeOf(u)))
    {
        block = blockOf_[u];
        for (const feRegion& region : regions_)
        {
            const fieldLayout& layout = region.layout();
            for (label f = 0; f < layout.nFields() && what.empty(); ++f)
            {
                for (label i = 0; i < layout.size(f) && what.empty(); ++i)
                {
                    const label cmpt = u - region.unknowns().start(f, i);
                    if (cmpt < 0 || cmpt >= layout.nComponents(f)) continue;
                    what =
                        layout.componentName(f, cmpt) + " of region " + region.name() + ' '
                      + layout.place(f, i);
                }
            }
        }
    }
    reduce(block, maxOp<label>());
    for (const string& s : gatherAll<string>(List<string>(1, what))) if (!s.empty()) what = s;
    return what.empty() ? string("an unknown that could not be found") : what;
}


// ************************************************************************* //
