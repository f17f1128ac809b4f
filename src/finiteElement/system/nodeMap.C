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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodeMap::findShared(const labelUList& key)
{
    const label nProcs = Pstream::nProcs(), me = Pstream::myProcNo();
    owned_.setSize(key.size(), true);
    if (!Pstream::parRun()) return;

    // Rendezvous: rank key % nProcs hears who has the key, and answers those
    // keys that several ranks have, with the list of the ranks
    List<DynamicList<label>> ask(nProcs);
    for (const label k : key) ask[k % nProcs].append(k);

    List<DynamicList<label>> asked(nProcs);
    Pstream::exchange<DynamicList<label>, label>(ask, asked);

    Map<DynamicList<label>> ranksOf;
    forAll(asked, rank)
    {
        for (const label k : asked[rank]) ranksOf(k).append(rank);
    }

    List<DynamicList<label>> answer(nProcs);
    forAll(asked, rank)
    {
        for (const label k : asked[rank])
        {
            const DynamicList<label>& ranks = ranksOf[k];
            if (ranks.size() == 1) continue;
            answer[rank].append(k);
            answer[rank].append(ranks.size());
            answer[rank].append(ranks);
        }
    }
    List<DynamicList<label>> answered(nProcs);
    Pstream::exchange<DynamicList<label>, label>(answer, answered);

    Map<label> nodeOf(2*key.size());
    forAll(key, n) nodeOf.insert(key[n], n);

    List<DynamicList<label>> sharedKeys(nProcs);
    for (const DynamicList<label>& a : answered)
    {
        for (label i = 0; i < a.size(); i += 2 + a[i + 1])
        {
            for (label j = 0; j < a[i + 1]; ++j)
            {
                const label rank = a[i + 2 + j];
                if (rank == me) continue;
                sharedKeys[rank].append(a[i]);
                if (rank < me) owned_[nodeOf[a[i]]] = false;
            }
        }
    }

    labelHashSet all;
    forAll(sharedKeys, rank)
    {
        if (sharedKeys[rank].empty()) continue;
        Foam::sort(sharedKeys[rank]);
        labelList nodes(sharedKeys[rank].size());
        forAll(nodes, i) nodes[i] = nodeOf[sharedKeys[rank][i]];
        all.insert(nodes);
        neighbours_.append(rank);
        shared_.append(nodes);
    }
    allShared_ = all.sortedToc();
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
{
    findShared(key);

    labelList n(nUnknowns);
    {
        List<scalarList> counts(nNodes());
        for (const label node : allShared_) counts[node] = scalarList(1, scalar(n[node]));
        if (Pstream::parRun())
        {
            combine(counts, [](scalarList& a, const scalarList& b) { a[0] = max(a[0], b[0]); });
        }
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
