/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodeMap.H"
#include "Map.H"
#include "Pstream.H"
#include "PstreamBuffers.H"
#include "SortableList.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodeMap::findShared()
{
    const label nProcs = Pstream::nProcs(), me = Pstream::myProcNo();
    owned_ = boolList(key_.size(), true);
    neighbours_.clear();
    shared_.clear();
    allShared_.clear();
    if (!Pstream::parRun()) return;

    // Rendezvous: rank key % nProcs hears who has the key, and whether as a
    // ghost, and answers those keys that several ranks have, with the list of
    // the ranks; of ghosts -1 - rank
    List<DynamicList<label>> ask(nProcs);
    forAll(key_, n)
    {
        DynamicList<label>& to = ask[key_[n] % nProcs];
        to.append(key_[n]);
        to.append(n < nOwn_ ? 0 : 1);
    }
    List<DynamicList<label>> asked(nProcs);
    Pstream::exchange<DynamicList<label>, label>(ask, asked);

    Map<DynamicList<label>> ranksOf;
    forAll(asked, rank)
    {
        for (label i = 0; i < asked[rank].size(); i += 2)
        {
            ranksOf(asked[rank][i]).append(asked[rank][i + 1] ? -1 - rank : rank);
        }
    }

    List<DynamicList<label>> answer(nProcs);
    forAll(asked, rank)
    {
        for (label i = 0; i < asked[rank].size(); i += 2)
        {
            const DynamicList<label>& ranks = ranksOf[asked[rank][i]];
            if (ranks.size() == 1) continue;
            answer[rank].append(asked[rank][i]);
            answer[rank].append(ranks.size());
            answer[rank].append(ranks);
        }
    }
    List<DynamicList<label>> answered(nProcs);
    Pstream::exchange<DynamicList<label>, label>(answer, answered);

    Map<label> nodeOfKey(2*key_.size());
    forAll(key_, n) nodeOfKey.insert(key_[n], n);

    List<DynamicList<label>> sharedKeys(nProcs);
    for (const DynamicList<label>& a : answered)
    {
        for (label i = 0; i < a.size(); i += 2 + a[i + 1])
        {
            for (label j = 0; j < a[i + 1]; ++j)
            {
                const bool ghost = a[i + 2 + j] < 0;
                const label rank = ghost ? -1 - a[i + 2 + j] : a[i + 2 + j];
                if (rank == me) continue;
                sharedKeys[rank].append(a[i]);
                if (!ghost && rank < me) owned_[nodeOfKey[a[i]]] = false;
            }
        }
    }
    for (label n = nOwn_; n < key_.size(); ++n) owned_[n] = false;

    labelHashSet all;
    forAll(sharedKeys, rank)
    {
        if (sharedKeys[rank].empty()) continue;
        Foam::sort(sharedKeys[rank]);
        labelList nodes(sharedKeys[rank].size());
        forAll(nodes, i) nodes[i] = nodeOfKey[sharedKeys[rank][i]];
        all.insert(nodes);
        neighbours_.append(rank);
        shared_.append(nodes);
    }
    allShared_ = all.sortedToc();
}


void Foam::nodeMap::number(const labelUList& nUnknowns)
{
    labelList n(nUnknowns);
    if (Pstream::parRun())
    {
        List<scalarList> counts(nNodes());
        for (const label node : allShared_) counts[node] = scalarList(1, scalar(n[node]));
        combine(counts, [](scalarList& a, const scalarList& b) { a[0] = max(a[0], b[0]); });
        for (const label node : allShared_) n[node] = label(counts[node][0]);
    }

    start_.setSize(nNodes() + 1);
    start_[0] = 0;
    DynamicList<label> nodes, unknowns;
    forAll(n, node)
    {
        start_[node + 1] = start_[node] + n[node];
        if (!owned_[node]) continue;
        nodes.append(node);
        for (label u = start_[node]; u < start_[node + 1]; ++u) unknowns.append(u);
    }
    ownedNodes_.transfer(nodes);
    ownedUnknowns_.transfer(unknowns);

    numbering_ = globalIndex(ownedUnknowns_.size());
    scalarField number(this->nUnknowns(), -1);
    forAll(ownedUnknowns_, i) number[ownedUnknowns_[i]] = numbering_.toGlobal(i);
    maximum(number);
    global_.setSize(number.size());
    forAll(number, u) global_[u] = label(number[u]);

    copyOf_.clear();
    for (const label node : allShared_)
    {
        if (owned_[node]) continue;
        for (label u = start_[node]; u < start_[node + 1]; ++u) copyOf_.insert(global_[u], u);
    }
}


template<class F>
void Foam::nodeMap::combine(List<scalarList>& own, const F& f) const
{
    // own[n]: what this rank has at shared node n. Each rank's contribution is
    // met in ascending order by all
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(neighbours_, i)
    {
        UOPstream toNeighbour(neighbours_[i], buffers);
        List<scalarList> send(shared_[i].size());
        forAll(send, j) send[j] = own[shared_[i][j]];
        toNeighbour << send;
    }
    buffers.finishedSends();

    boolList begun(own.size(), false);
    List<scalarList> result(own.size());
    const auto meet = [&](const label node, const scalarList& values)
    {
        if (begun[node]) f(result[node], values);
        else
        {
            result[node] = values;
            begun[node] = true;
        }
    };

    bool mineDone = false;
    const auto meetMine = [&]()
    {
        for (const label node : allShared_) meet(node, own[node]);
        mineDone = true;
    };
    forAll(neighbours_, i)
    {
        if (!mineDone && neighbours_[i] > Pstream::myProcNo()) meetMine();
        UIPstream fromNeighbour(neighbours_[i], buffers);
        const List<scalarList> received(fromNeighbour);
        forAll(received, j) meet(shared_[i][j], received[j]);
    }
    if (!mineDone) meetMine();

    for (const label node : allShared_) own[node].transfer(result[node]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodeMap::nodeMap(const labelUList& key, const labelUList& nUnknowns)
:
    key_(key),
    nOwn_(key.size())
{
    findShared();
    number(nUnknowns);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nodeMap::addGhosts(const labelUList& key)
{
    labelHashSet here(key_);
    DynamicList<label> all(key_);
    for (const label k : key) if (here.insert(k)) all.append(k);

    labelList counts(all.size(), 0);
    for (label n = 0; n < nNodes(); ++n) counts[n] = nUnknowns(n);
    key_.transfer(all);
    findShared();
    number(counts);
}


Foam::label Foam::nodeMap::nodeOf(const label unknown) const
{
    return label(std::upper_bound(start_.begin(), start_.end(), unknown) - start_.begin()) - 1;
}


Foam::label Foam::nodeMap::local(const label global) const
{
    if (numbering_.isLocal(global)) return ownedUnknowns_[numbering_.toLocal(global)];
    const auto found = copyOf_.cfind(global);
    return found.found() ? *found : -1;
}


void Foam::nodeMap::sum(scalarField& x) const
{
    if (!Pstream::parRun()) return;

    // The fast path of combine(): one flat buffer a neighbour
    List<scalarList> received(neighbours_.size());
    {
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
        forAll(neighbours_, i)
        {
            DynamicList<scalar> send;
            for (const label node : shared_[i])
            {
                for (label u = start_[node]; u < start_[node + 1]; ++u) send.append(x[u]);
            }
            UOPstream toNeighbour(neighbours_[i], buffers);
            toNeighbour << send;
        }
        buffers.finishedSends();
        forAll(neighbours_, i)
        {
            UIPstream fromNeighbour(neighbours_[i], buffers);
            fromNeighbour >> received[i];
        }
    }

    scalarField mine(x);
    for (const label node : allShared_)
    {
        for (label u = start_[node]; u < start_[node + 1]; ++u) x[u] = 0;
    }
    bool mineDone = false;
    const auto addMine = [&]()
    {
        for (const label node : allShared_)
        {
            for (label u = start_[node]; u < start_[node + 1]; ++u) x[u] += mine[u];
        }
        mineDone = true;
    };
    forAll(neighbours_, i)
    {
        if (!mineDone && neighbours_[i] > Pstream::myProcNo()) addMine();
        label k = 0;
        for (const label node : shared_[i])
        {
            for (label u = start_[node]; u < start_[node + 1]; ++u) x[u] += received[i][k++];
        }
    }
    if (!mineDone) addMine();
}


void Foam::nodeMap::fromOwner(scalarField& x) const
{
    if (!Pstream::parRun()) return;
    forAll(owned_, node)
    {
        if (owned_[node]) continue;
        for (label u = start_[node]; u < start_[node + 1]; ++u) x[u] = 0;
    }
    sum(x);
}


void Foam::nodeMap::maximum(scalarField& x) const
{
    if (!Pstream::parRun()) return;
    List<scalarList> values(nNodes());
    for (const label node : allShared_)
    {
        values[node] = scalarList(SubList<scalar>(x, nUnknowns(node), start_[node]));
    }
    combine
    (
        values,
        [](scalarList& a, const scalarList& b)
        {
            forAll(a, i) a[i] = max(a[i], b[i]);
        }
    );
    for (const label node : allShared_)
    {
        forAll(values[node], i) x[start_[node] + i] = values[node][i];
    }
}


Foam::scalar Foam::nodeMap::dot
(
    const scalarField& x,
    const scalarField& y
) const
{
    scalar s = 0;
    for (const label u : ownedUnknowns_) s += x[u]*y[u];
    return returnReduce(s, sumOp<scalar>());
}


// ************************************************************************* //
