/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dofConstraints.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dofConstraints::same(const row& r, const row& s)
{
    // Sums of ranks agree to round-off
    const auto close = [](const scalar a, const scalar b)
    {
        return mag(a - b) <= 1e-9*(1 + mag(a) + mag(b));
    };
    if (r.terms.size() != s.terms.size() || !close(r.b, s.b)) return false;
    forAll(r.terms, i)
    {
        if (r.terms[i].unknown != s.terms[i].unknown) return false;
        if (!close(r.terms[i].weight, s.terms[i].weight)) return false;
        if (!close(r.terms[i].transposed, s.terms[i].transposed)) return false;
    }
    return true;
}


void Foam::dofConstraints::share()
{
    if (!Pstream::parRun()) return;

    // Place in the list of shared nodes, component, row
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(map_.neighbours(), i)
    {
        DynamicList<label> at;
        DynamicList<row> rows;
        forAll(map_.shared(i), j)
        {
            const label node = map_.shared(i)[j];
            for (label u = map_.start(node); u < map_.start(node + 1); ++u)
            {
                const auto found = declared_.cfind(u);
                if (!found.found()) continue;
                at.append(j);
                at.append(u - map_.start(node));
                rows.append(*found);
            }
        }
        UOPstream to(map_.neighbours()[i], buffers);
        to << static_cast<labelList&>(at) << static_cast<List<row>&>(rows);
    }
    buffers.finishedSends();

    forAll(map_.neighbours(), i)
    {
        UIPstream from(map_.neighbours()[i], buffers);
        const labelList at(from);
        const List<row> rows(from);
        forAll(rows, k)
        {
            // What a ghost is tied to is its owner's matter
            const label node = map_.shared(i)[at[2*k]];
            if (node >= map_.nOwn()) continue;
            const label u = map_.start(node) + at[2*k + 1];
            if (declared_.insert(u, rows[k]) || same(declared_[u], rows[k])) continue;
            FatalErrorInFunction
                << "Ranks " << Pstream::myProcNo() << " and " << map_.neighbours()[i]
                << " have different constraints of unknown " << map_.global(u) << ':'
                << nl << declared_[u] << nl << rows[k] << exit(FatalError);
        }
    }
}


void Foam::dofConstraints::fetch(const labelHashSet& global, Map<row>& rows) const
{
    const label nProcs = Pstream::nProcs();
    List<DynamicList<label>> ask(nProcs), asked(nProcs);
    for (const label g : global.sortedToc()) ask[map_.numbering().whichProcID(g)].append(g);
    Pstream::exchange<DynamicList<label>, label>(ask, asked);

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(asked, rank)
    {
        if (asked[rank].empty()) continue;
        DynamicList<label> tied;
        DynamicList<row> answer;
        for (const label g : asked[rank])
        {
            const auto found = declared_.cfind(map_.local(g));
            if (!found.found()) continue;
            tied.append(g);
            answer.append(*found);
        }
        UOPstream to(rank, buffers);
        to << static_cast<labelList&>(tied) << static_cast<List<row>&>(answer);
    }
    buffers.finishedSends();
    forAll(ask, rank)
    {
        if (ask[rank].empty()) continue;
        UIPstream from(rank, buffers);
        const labelList tied(from);
        const List<row> answer(from);
        forAll(tied, i) rows.insert(tied[i], answer[i]);
    }
}


Foam::Map<Foam::dofConstraints::row> Foam::dofConstraints::closed() const
{
    Map<row> rows(declared_);
    Map<row> remote;
    labelHashSet known;

    const auto here = [&](const label g)
    {
        const label u = map_.local(g);
        return u >= 0 && map_.nodeOf(u) < map_.nOwn();
    };
    const auto rowOf = [&](const label g) -> const row*
    {
        const auto found = here(g) ? declared_.cfind(map_.local(g)) : remote.cfind(g);
        return found.found() ? &*found : nullptr;
    };

    for (label pass = 0, changed = 1; changed; ++pass)
    {
        // Of masters that are not here it must be known whether they are tied
        labelHashSet wanted;
        forAllConstIters(rows, iter) for (const term& t : iter().terms)
        {
            if (!here(t.unknown) && known.insert(t.unknown)) wanted.insert(t.unknown);
        }
        if (Pstream::parRun()) fetch(wanted, remote);

        changed = 0;
        forAllIters(rows, iter)
        {
            row& r = iter();
            DynamicList<term> terms;
            scalar b = r.b;
            bool any = false;
            for (const term& t : r.terms)
            {
                const row* master = rowOf(t.unknown);
                if (!master || master->terms.empty())
                {
                    terms.append(t);
                    continue;
                }
                any = true;
                if (t.unknown == map_.global(iter.key()) || pass > 1000)
                {
                    FatalErrorInFunction
                        << "The constraint of unknown " << map_.global(iter.key())
                        << " refers to itself through unknown " << t.unknown
                        << exit(FatalError);
                }
                for (const term& m : master->terms)
                {
                    terms.append({m.unknown, t.weight*m.weight, t.transposed*m.transposed});
                }
                b += t.weight*master->b;
            }
            if (!any) continue;
            changed = 1;

            // A master met on two ways counts once
            std::stable_sort
            (
                terms.begin(), terms.end(),
                [](const term& s, const term& t) { return s.unknown < t.unknown; }
            );
            DynamicList<term> once;
            for (const term& t : terms)
            {
                if (once.empty() || once.last().unknown != t.unknown) once.append(t);
                else
                {
                    once.last().weight += t.weight;
                    once.last().transposed += t.transposed;
                }
            }
            r.terms.transfer(once);
            r.b = b;
        }
        reduce(changed, maxOp<label>());
    }
    return rows;
}


void Foam::dofConstraints::addGhosts(const Map<row>& rows)
{
    if (!Pstream::parRun()) return;

    const label nProcs = Pstream::nProcs();
    labelHashSet missing;
    forAllConstIters(rows, iter) for (const term& t : iter().terms)
    {
        if (map_.local(t.unknown) < 0) missing.insert(t.unknown);
    }
    List<DynamicList<label>> ask(nProcs), asked(nProcs), answer(nProcs), answered(nProcs);
    for (const label g : missing.sortedToc()) ask[map_.numbering().whichProcID(g)].append(g);
    Pstream::exchange<DynamicList<label>, label>(ask, asked);
    forAll(asked, rank) for (const label g : asked[rank])
    {
        answer[rank].append(map_.key(map_.nodeOf(map_.local(g))));
    }
    Pstream::exchange<DynamicList<label>, label>(answer, answered);

    labelHashSet keys;
    for (const DynamicList<label>& a : answered) keys.insert(a);
    const labelList sorted(keys.sortedToc());
    if (returnReduce(sorted.size(), sumOp<label>())) map_.addGhosts(sorted);
}


void Foam::dofConstraints::impose(scalarField& x, const scalar factorOfB) const
{
    forAll(slaves_, r)
    {
        scalar& xi = x[slaves_[r]];
        xi = factorOfB*rows_[r].b;
        for (const term& t : rows_[r].terms) xi += t.weight*x[t.unknown];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dofConstraints::tie
(
    const label unknown,
    const UList<term>& masters,
    const scalar b
)
{
    List<term> global(masters);
    for (term& t : global) t.unknown = map_.global(t.unknown);
    tieGlobal(unknown, global, b);
}


void Foam::dofConstraints::tieGlobal
(
    const label unknown,
    const UList<term>& masters,
    const scalar b
)
{
    row r;
    r.terms = masters;
    std::sort
    (
        r.terms.begin(), r.terms.end(),
        [](const term& s, const term& t) { return s.unknown < t.unknown; }
    );
    r.b = b;
    declared_.set(unknown, r);
}


bool Foam::dofConstraints::close()
{
    const label nBefore = map_.nUnknowns();
    const labelList rowBefore(row_), slavesBefore(slaves_);
    List<row> rowsBefore(rows_);

    share();
    const Map<row> rows(closed());
    addGhosts(rows);

    row_ = labelList(map_.nUnknowns(), FREE);
    slaves_.clear();
    rows_.clear();
    DynamicList<label> slaves;
    DynamicList<row> local;
    for (const label u : rows.sortedToc())
    {
        if (rows[u].terms.empty())
        {
            row_[u] = GIVEN;
            continue;
        }
        row_[u] = slaves.size();
        slaves.append(u);
        local.append(rows[u]);
        for (term& t : local.last().terms) t.unknown = map_.local(t.unknown);
    }
    slaves_.transfer(slaves);
    rows_.transfer(local);

    // What the ranks know that have more of a ghost than its number
    scalarField kind(row_.size(), 0);
    forAll(row_, u) kind[u] = row_[u] == GIVEN ? 1 : row_[u] >= 0 ? 2 : 0;
    map_.maximum(kind);
    forAll(row_, u)
    {
        if (row_[u] != FREE || kind[u] == 0) continue;
        row_[u] = kind[u] == 1 ? GIVEN : ELSEWHERE;
    }

    dependent_.setSize(rows_.size());
    forAll(rows_, r)
    {
        dependent_[r] = true;
        for (const term& t : rows_[r].terms) if (isFree(t.unknown)) dependent_[r] = false;
    }

    // The same unknowns in the same kinds, and masters at the same nodes
    bool kept = nBefore == map_.nUnknowns() && rowBefore == row_ && slavesBefore == slaves_;
    const auto nodes = [&](const row& r)
    {
        labelHashSet all;
        for (const term& t : r.terms) all.insert(map_.nodeOf(t.unknown));
        return all;
    };
    forAll(rows_, r) kept = kept && nodes(rows_[r]) == nodes(rowsBefore[r]);
    return returnReduce(kept, andOp<bool>());
}


void Foam::dofConstraints::distribute(scalarField& dx) const
{
    forAll(row_, i) if (row_[i] == GIVEN) dx[i] = 0;
    impose(dx, 0);
}


void Foam::dofConstraints::condense(scalarField& r) const
{
    forAll(slaves_, k)
    {
        scalar& ri = r[slaves_[k]];
        for (const term& t : rows_[k].terms) r[t.unknown] += t.transposed*ri;
        ri = 0;
    }
    forAll(row_, i) if (row_[i] == GIVEN) r[i] = 0;
}


// ************************************************************************* //
