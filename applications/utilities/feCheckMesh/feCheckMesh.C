/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    feCheckMesh

Description
    The shape of the elements of a mesh, at the times selected: worst values,
    histogram and worst elements of each measure (elementQuality.H), with fields
    of the cells if asked for. Changes are those since constant/polyMesh.

        feCheckMesh [-region <name>] [-order 1|2] [-histogram] [-worst <n>]
                    [-writeFields] [-dict <file>] [-time <ranges>] [-parallel]

    The limits are those of system/<region>/feCheckMeshDict, or the file given,
    if there is one:

    \verbatim
        limits { scaledJacobian 0.1; aspectRatio 20; VOCH 5; }  // qualityLimits.H
    \endverbatim

    Of each time a line: time, worst values, number of elements past a limit.
    The exit status is 1 if any element is, at any time. An inverted element
    (a scaled Jacobian that is not positive) is past a limit always.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "timeSelector.H"
#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"
#include "pointIOField.H"
#include "qualityLimits.H"
#include "refuseBlanks.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"
#include "gatherAll.H"
#include "Tuple2.H"
#include <algorithm>

using namespace Foam;

namespace
{

//- The mesh's elements and their measures, now and before it moved
class meshCheck
{
    const fvMesh& mesh_;
    const pointIOField points0_;
    const feMesh fe_;
    const elementQualities reference_;
    elementQualities now_;

    //- Call f(element's cell, value) for all elements
    template<class F>
    void forValues(const qualityMeasure& measure, const F& f) const
    {
        forAll(now_, b) forAll(now_[b], e)
        {
            f(fe_.blocks()[b].cells[e], measure.of(now_[b][e], reference_[b][e]));
        }
    }

    static IOobject undeformed(const fvMesh& mesh)
    {
        return IOobject
        (
            "points", mesh.time().constant(), polyMesh::meshSubDir, mesh,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        );
    }

public:

    meshCheck(const fvMesh& mesh, const label order)
    :
        mesh_(mesh),
        points0_(undeformed(mesh)),
        fe_(mesh, order, dictionary::null, points0_),
        reference_(qualities(fe_, fe_.points()))
    {}

    //- The mesh has moved
    void update()
    {
        const vectorField D(mesh_.points() - points0_);
        now_ = qualities(fe_, fe_.points() + fe_.interpolate(D));
    }

    scalar worst(const qualityMeasure& measure) const
    {
        scalar w = measure.smallIsBad ? GREAT : -GREAT;
        forValues(measure, [&](const label, const scalar v) { if (measure.worse(v, w)) w = v; });
        measure.smallIsBad ? reduce(w, minOp<scalar>()) : reduce(w, maxOp<scalar>());
        return w;
    }

    labelList nBroken(const qualityLimits& limits) const { return limits.nBroken(now_, reference_); }

    //- Number of elements in ten classes between the extremes
    void histogram(const qualityMeasure& measure) const
    {
        constexpr label nClasses = 10;
        scalar low = GREAT, high = -GREAT;
        forValues(measure, [&](const label, const scalar v) { low = min(low, v); high = max(high, v); });
        reduce(low, minOp<scalar>());
        reduce(high, maxOp<scalar>());
        labelList n(nClasses, 0);
        const scalar width = max((high - low)/nClasses, VSMALL);
        forValues(measure, [&](const label, const scalar v) { ++n[min(label((v - low)/width), nClasses - 1)]; });
        for (label& nk : n) reduce(nk, sumOp<label>());
        Info<< "    " << measure.name << nl;
        forAll(n, k) Info<< "        from " << low + k*width << ": " << n[k] << nl;
    }

    //- The worst elements, with their places
    void worstElements(const qualityMeasure& measure, const label nWorst) const
    {
        typedef Tuple2<scalar, Tuple2<label, point>> element;
        const auto worse = [&](const element& a, const element& b) { return measure.worse(a.first(), b.first()); };
        DynamicList<element> mine;
        forValues(measure, [&](const label celli, const scalar v)
        {
            mine.append(element(v, Tuple2<label, point>(celli, mesh_.cellCentres()[celli])));
        });
        std::sort(mine.begin(), mine.end(), worse);
        mine.setSize(min(mine.size(), nWorst));
        List<element> all(gatherAll<element>(mine));
        std::sort(all.begin(), all.end(), worse);
        Info<< "    " << measure.name << nl;
        for (label i = 0; i < min(all.size(), nWorst); ++i)
        {
            const auto& cell = all[i].second();
            Info<< "        " << all[i].first() << "  cell " << cell.first() << " at " << cell.second() << nl;
        }
    }

    void writeField(const qualityMeasure& measure) const
    {
        volScalarField field
        (
            IOobject(measure.name, mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(dimless, Zero)
        );
        forValues(measure, [&](const label celli, const scalar v) { field[celli] = v; });
        field.correctBoundaryConditions();
        field.write();
    }
};


qualityLimits readLimits(const fvMesh& mesh, const argList& args)
{
    const fileName given(args.getOrDefault<fileName>("dict", ""));
    const IOobject io
    (
        "feCheckMeshDict", mesh.time().system(), mesh,
        given.empty() ? IOobject::READ_IF_PRESENT : IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    const IOdictionary dict(IOobject::selectIO(io, given));
    if (!dict.empty()) reportUnknownEntries(dict, {"limits"});
    return qualityLimits(subDictOrEmpty(dict, "limits"));
}


//- Report of a time; returns whether all elements keep the limits
bool report(const meshCheck& check, const qualityLimits& limits, const argList& args, const scalar time)
{
    const List<qualityMeasure>& measures = qualityMeasures();
    const labelList n(check.nBroken(limits));
    const label nWorst = args.getOrDefault<label>("worst", 0);

    Info<< "Time = " << time;
    forAll(measures, m)
    {
        Info<< "  " << measures[m].extreme << ' ' << check.worst(measures[m]);
        if (n[m]) Info<< " (" << n[m] << " past the limit)";
    }
    Info<< nl;
    if (args.found("histogram")) for (const qualityMeasure& m : measures) check.histogram(m);
    if (nWorst) for (const qualityMeasure& m : measures) check.worstElements(m, nWorst);
    if (args.found("writeFields")) for (const qualityMeasure& m : measures) check.writeField(m);
    return sum(n) == 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("The shape of the elements of a mesh, with limits.");
    timeSelector::addOptions(true, true);
    #include "addRegionOption.H"
    argList::addOption("order", "1|2", "Order of the elements (default 1)");
    argList::addBoolOption("histogram", "Numbers of elements in classes of each measure");
    argList::addOption("worst", "n", "The n worst elements of each measure");
    argList::addBoolOption("writeFields", "Fields of the measures");
    argList::addOption("dict", "file", "Instead of system/feCheckMeshDict");

    refuseBlanks(argc, argv);
    #include "setRootCase.H"
    #include "createTime.H"
    const instantList times = timeSelector::selectIfPresent(runTime, args);
    #include "createNamedMesh.H"
    Info().precision(6);

    const label order = args.getOrDefault<label>("order", 1);
    if (order != 1 && order != 2)
    {
        FatalErrorInFunction << "-order is " << order << ", expected 1 or 2" << exit(FatalError);
    }
    const qualityLimits limits(readLimits(mesh, args));
    meshCheck check(mesh, order);

    bool good = true;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        if (mesh.readUpdate() >= polyMesh::TOPO_CHANGE)
        {
            FatalErrorInFunction
                << "At time " << runTime.timeName() << " the mesh has other cells than in constant:"
                << " select times with one mesh" << exit(FatalError);
        }
        check.update();
        good = report(check, limits, args, runTime.value()) && good;
    }

    Info<< nl << (good ? "All elements keep the limits." : "Some elements are past a limit.") << nl << endl;

    // The end of argList would exit with 0
    if (!good) UPstream::exit(1);
    return 0;
}


// ************************************************************************* //
