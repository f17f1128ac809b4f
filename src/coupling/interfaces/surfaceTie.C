/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceTie.H"
#include "interfaceFit.H"
#include "fourDigits.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static wordList patchNames(const feRegion& region, const labelUList& patches)
{
    return wordList(UIndirectList<word>(region.mesh().boundaryMesh().names(), patches));
}


static scalar percent(const scalar part, const scalar whole)
{
    return 100*part/max(whole, VSMALL);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::surfaceTie::tooMuch(const interfaceFit& fit) const
{
    if (unmatched_ == 0) return fit.nGaps;
    return fit.uncovered >= (1 - 1e-6)*fit.area || percent(fit.uncovered, fit.area) > unmatched_;
}


void Foam::surfaceTie::check(const interfaceFit& fit) const
{
    const bool gaps = tooMuch(fit);
    if (!gaps && fit.wrongWay <= 0.5*fit.area) return;
    const feRegion &follower = interface_.follower(), &leader = interface_.leader();
    FatalIOErrorInFunction(dict_)
        << "Interface " << interface_.name() << ": patches "
        << patchNames(follower, interface_.followerPatches()) << " of region " << follower.name()
        << " and " << patchNames(leader, interface_.leaderPatches()) << " of region " << leader.name();
    if (!gaps)
    {
        FatalIOError
            << " do not face each other: on " << fourDigits(percent(fit.wrongWay, fit.area)) << " % of the area of "
            << follower.name() << " both look the same way." << nl
            << "Is " << follower.name() << " on the other side of " << leader.name() << '?';
    }
    else
    {
        const bool apart = fit.uncovered >= (1 - 1e-6)*fit.area;
        FatalIOError
            << (apart ? " have no area in common. " : " do not meet everywhere. ")
            << fit.nGaps << " of " << fit.nNodes << " nodes of " << follower.name() << " have no face of "
            << leader.name() << " within " << fourDigits(tolerance_)
            << " of the size of a face; the largest gap is " << fourDigits(fit.largestGap)
            << " m at " << fit.where << ", " << fourDigits(percent(fit.uncovered, fit.area))
            << " % of the area of " << follower.name() << " are uncovered, at most "
            << fourDigits(unmatched_) << " % may be." << nl
            << "Give the part of the patch that does not touch " << leader.name() << " a patch of its own,"
            << " or, where curved surfaces differ, a larger tolerance; or say with unmatched how many"
            << " percent may be without a partner";
    }
    FatalIOError << exit(FatalIOError);
}


void Foam::surfaceTie::report
(
    const interfaceFit& fit,
    const interfaceSurface& surface,
    const vectorField& xLeader,
    const vectorField& xFollower
)
{
    if (reported_) return;
    reported_ = true;
    const feRegion &follower = interface_.follower(), &leader = interface_.leader();
    const interfaceSurface wet(follower, interface_.followerPatches(), xFollower);
    const interfaceFit dry(leader, interface_.leaderPatches(), xLeader, wet, tolerance_);
    Info<< "Interface " << interface_.name() << ": " << fit.nNodes << " nodes of " << follower.name()
        << " on " << surface.nFaces() << " faces of " << leader.name() << ", weights " << weights_->type()
        << ", largest gap " << fourDigits(fit.largestGap) << " m at " << fit.where << ", unmatched "
        << fourDigits(percent(fit.uncovered, fit.area)) << " % of the area of " << follower.name() << ", "
        << fourDigits(percent(dry.uncovered, dry.area)) << " % of that of " << leader.name() << nl;
}


void Foam::surfaceTie::makeExchange(const interfaceSurface& surface)
{
    DynamicList<label> places;
    for (const List<interfaceSurface::term>& row : rows_) for (const auto& t : row) places.append(t.node);
    List<Map<label>> byRank;
    exchange_.reset(new mapDistribute(surface.numbering(), places, byRank));
    label k = 0;
    for (List<interfaceSurface::term>& row : rows_) for (auto& t : row) t.node = places[k++];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceTie::surfaceTie(const feInterface& interface, const dictionary& dict, const bool snap)
:
    interface_(interface),
    dict_(dict),
    weights_(interfaceWeights::New(dict)),
    tolerance_(dict.found("tolerance") ? readNumber(dict, "tolerance", dimless, 0, 10) : 0.2),
    unmatched_(dict.found("unmatched") ? readNotNegative(dict, "unmatched", dimless) : 0),
    snap_(snap),
    reported_(false)
{}


Foam::surfaceTie::~surfaceTie() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::surfaceTie::present(const feRegion& region)
{
    return region.fe().points() + region.motion().D;
}


bool Foam::surfaceTie::find
(
    const vectorField& xLeader,
    const vectorField& xFollower,
    const bool must
)
{
    const feRegion &follower = interface_.follower(), &leader = interface_.leader();
    const interfaceSurface surface(leader, interface_.leaderPatches(), xLeader, !snap_);
    const interfaceFit fit(follower, interface_.followerPatches(), xFollower, surface, tolerance_);
    if (!must && tooMuch(fit)) return false;
    check(fit);
    report(fit, surface, xLeader, xFollower);

    nodes_ = interface_.followerNodes();
    rows_ = weights_->rows(fit, nodes_);
    makeExchange(surface);

    // x = sum W (X_l + D_l) = X_f + D_f
    offset_ = fromLeader(leader.fe().points());
    forAll(offset_, i)
    {
        const point& X = follower.fe().points()[nodes_[i]];
        offset_[i] = surface.flat(offset_[i] - X);
        if (!isMatched(i) || mag(offset_[i]) < 1e-12*(1 + mag(X))) offset_[i] = Zero;
    }
    return true;
}


Foam::tmp<Foam::vectorField> Foam::surfaceTie::fromLeader(const vectorField& f) const
{
    vectorField y(f);
    exchange_->distribute(y);
    tmp<vectorField> tv(new vectorField(rows_.size(), Zero));
    forAll(rows_, i) for (const auto& t : rows_[i]) tv.ref()[i] += t.weight*y[t.node];
    return tv;
}


void Foam::surfaceTie::constrain(dofConstraints& c) const
{
    // First unknown of the leader's nodes, by global number
    const feRegion &follower = interface_.follower(), &leader = interface_.leader();
    const fieldUnknowns &masters = leader.unknowns(), &slaves = follower.unknowns();
    labelList start(leader.fe().nNodes());
    forAll(start, n) start[n] = masters.map().global(masters.start(0, n));
    exchange_->distribute(start);
    forAll(nodes_, i)
    {
        List<dofConstraints::term> terms(rows_[i].size());
        for (label a = 0; a < follower.fe().dim(); ++a)
        {
            forAll(terms, k) terms[k] = {start[rows_[i][k].node] + a, rows_[i][k].weight};
            c.tieGlobal(slaves.start(0, nodes_[i]) + a, terms);
        }
    }
}


Foam::interfaceGap Foam::surfaceTie::gap() const
{
    const feRegion &follower = interface_.follower(), &leader = interface_.leader();
    const interfaceSurface surface(leader, interface_.leaderPatches(), present(leader));
    const vectorField x(present(follower));
    const interfaceFit fit(follower, interface_.followerPatches(), x, surface, tolerance_);
    interfaceGap gap;
    forAll(nodes_, i)
    {
        if (isMatched(i)) gap.distance = max(gap.distance, surface.project(x[nodes_[i]]).distance);
    }
    reduce(gap.distance, maxOp<scalar>());
    gap.leakage = fit.leakage(follower.motion().v, leader.motion().v);
    return gap;
}


// ************************************************************************* //
