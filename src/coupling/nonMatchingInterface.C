/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nonMatchingInterface.H"
#include "interfaceFit.H"
#include "fourDigits.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(nonMatchingInterface, 0);
    addToRunTimeSelectionTable(feInterface, nonMatchingInterface, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static vectorField present(const feRegion& region)
{
    return region.fe().points() + region.motion().D;
}


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

void Foam::nonMatchingInterface::checkFit(const interfaceFit& fit) const
{
    if (!fit.nGaps && fit.wrongWay <= 0.5*fit.area) return;
    FatalIOErrorInFunction(dict())
        << "Interface " << name() << ": patches " << patchNames(fluid(), fluidPatches())
        << " of region " << fluid().name() << " and " << patchNames(solid(), solidPatches())
        << " of region " << solid().name();
    if (!fit.nGaps)
    {
        FatalIOError
            << " do not face each other: on " << fourDigits(percent(fit.wrongWay, fit.area))
            << " % of the fluid's area both look the same way." << nl
            << "Is the fluid on the other side of the solid?";
    }
    else
    {
        const bool apart = fit.uncovered >= (1 - 1e-6)*fit.area;
        FatalIOError
            << (apart ? " have no area in common. " : " do not meet everywhere. ")
            << fit.nGaps << " of " << fit.nNodes
            << " nodes of the fluid have no face of the solid within " << fourDigits(tolerance_)
            << " of the size of a face; the largest gap is " << fourDigits(fit.largestGap)
            << " m at " << fit.where << ", " << fourDigits(percent(fit.uncovered, fit.area))
            << " % of the fluid's area are uncovered." << nl
            << "Give the part of the fluid's patch that does not touch the solid a patch of its own,"
            << " or, where curved surfaces differ, a larger tolerance";
    }
    FatalIOError << exit(FatalIOError);
}


void Foam::nonMatchingInterface::report
(
    const interfaceFit& fit,
    const interfaceSurface& surface,
    const vectorField& xSolid,
    const vectorField& xFluid
)
{
    if (reported_) return;
    reported_ = true;
    const interfaceSurface wet(fluid(), fluidPatches(), xFluid);
    const interfaceFit dry(solid(), solidPatches(), xSolid, wet, tolerance_);
    Info<< "Interface " << name() << ": " << fit.nNodes << " nodes of " << fluid().name()
        << " on " << surface.nFaces() << " faces of " << solid().name()
        << ", weights " << weights_->type() << ", largest gap " << fourDigits(fit.largestGap)
        << " m at " << fit.where << ", unmatched " << fourDigits(percent(fit.uncovered, fit.area))
        << " % of the fluid's area, " << fourDigits(percent(dry.uncovered, dry.area))
        << " % of the solid's" << nl;
}


bool Foam::nonMatchingInterface::find
(
    const vectorField& xSolid,
    const vectorField& xFluid,
    const bool must
)
{
    const interfaceSurface surface(solid(), solidPatches(), xSolid);
    const interfaceFit fit(fluid(), fluidPatches(), xFluid, surface, tolerance_);
    if (fit.nGaps && !must) return false;
    checkFit(fit);
    report(fit, surface, xSolid, xFluid);

    followers_ = fluidNodes();
    rows_ = weights_->rows(fluid(), fluidPatches(), followers_, xFluid, surface);

    // The weights' nodes to this rank
    DynamicList<label> places;
    for (const List<interfaceSurface::term>& row : rows_) for (const auto& t : row) places.append(t.node);
    List<Map<label>> byRank;
    exchange_.reset(new mapDistribute(surface.numbering(), places, byRank));
    label k = 0;
    for (List<interfaceSurface::term>& row : rows_) for (auto& t : row) t.node = places[k++];

    // x = sum W (X_s + D_s) = X_f + D_f
    offset_ = atFollowers(solid().fe().points());
    forAll(offset_, i)
    {
        const point& X = fluid().fe().points()[followers_[i]];
        offset_[i] = surface.flat(offset_[i] - X);
        if (mag(offset_[i]) < 1e-12*(1 + mag(X))) offset_[i] = Zero;
    }
    return true;
}


bool Foam::nonMatchingInterface::holds() const
{
    const vectorField &D = fluid().motion().D, D0(atFollowers(solid().motion().D) + offset_);
    scalar size = 0, difference = 0;
    forAll(followers_, i)
    {
        size = max(size, mag(D0[i]));
        difference = max(difference, mag(D[followers_[i]] - D0[i]));
    }
    reduce(size, maxOp<scalar>());
    reduce(difference, maxOp<scalar>());
    return difference <= 1e-6*size;
}


Foam::tmp<Foam::vectorField> Foam::nonMatchingInterface::atFollowers(const vectorField& f) const
{
    vectorField y(f);
    exchange_->distribute(y);
    tmp<vectorField> tv(new vectorField(rows_.size(), Zero));
    forAll(rows_, i) for (const auto& t : rows_[i]) tv.ref()[i] += t.weight*y[t.node];
    return tv;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonMatchingInterface::nonMatchingInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    feInterface(name, dict, regions),
    weights_(interfaceWeights::New(dict)),
    tolerance_(dict.lookupOrDefault<scalar>("tolerance", 0.2)),
    reported_(false)
{
    reportUnknownEntries(dict, {"type", "fluid", "solid", "tolerance", "weights"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::nonMatchingInterface::joined
(
    const labelUList&,
    const labelUList&
) const
{
    checkFree();
    return List<labelPair>();
}


void Foam::nonMatchingInterface::constrain(dofConstraints& c)
{
    if (!find(solid().fe().points(), fluid().fe().points(), false) || (followed() && !holds()))
    {
        find(present(solid()), present(fluid()), true);
    }

    // First unknown of the solid's nodes, by global number
    const fieldUnknowns &masters = solid().unknowns(), &slaves = fluid().unknowns();
    labelList start(solid().fe().nNodes());
    forAll(start, n) start[n] = masters.map().global(masters.start(0, n));
    exchange_->distribute(start);
    forAll(followers_, i)
    {
        List<dofConstraints::term> terms(rows_[i].size());
        for (label a = 0; a < fluid().fe().dim(); ++a)
        {
            forAll(terms, k) terms[k] = {start[rows_[i][k].node] + a, rows_[i][k].weight};
            c.tieGlobal(slaves.start(0, followers_[i]) + a, terms);
        }
    }
}


void Foam::nonMatchingInterface::follow()
{
    const motionField& s = static_cast<const feRegion&>(solid()).motion();
    motionField& f = fluid().motion();
    const vectorField D(atFollowers(s.D)), v(atFollowers(s.v)), a(atFollowers(s.a));
    forAll(followers_, i)
    {
        const label n = followers_[i];
        f.D[n] = D[i] + offset_[i];
        f.v[n] = v[i];
        f.a[n] = a[i];
    }
}


// ************************************************************************* //
