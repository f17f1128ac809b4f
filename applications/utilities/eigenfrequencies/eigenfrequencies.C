/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    eigenfrequencies [-n N] [-shift f]

Description
    Frequencies and modes of small undamped vibrations of a case's solids about the
    state from which monolithicFoam would go on (startFrom in controlDict): as it is
    built, or pre-stressed by a run that ended there. Materials count with their
    slow moduli, without Prony series and damping. With fluids, which must be at
    rest, also those with the mass of the fluids round the solids.

        -n N        number of frequencies (6)
        -shift f    Hz (0): the frequencies next to it are found; solids that are
                    not held need one, as a tenth of their lowest frequency

    Writes postProcessing/eigenfrequencies/<time>/frequencies.dat (columns f1, f2,
    ... of the solids alone and, with fluids, w1, w2, ..., Hz) and the modes as point fields mode1,
    mode2, ... of the solids in the time's directory, the wet ones with fluids; the
    largest displacement of a mode is 1 m. On one rank.

    See vibrations.H for the method.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "exitOnError.H"
#include "refuseBlanks.H"
#include "mathematicalConstants.H"
#include "vibrations.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void checkFluids(const coupledSystem& system)
{
    for (const feRegion& region : system.regions())
    {
        const vectorField* U = region.state().find<vector>("U");
        if (!U || max(mag(*U)) == 0) continue;
        FatalErrorInFunction
            << "Fluid " << region.name() << " is not at rest: its largest velocity is "
            << max(mag(*U)) << " m/s. The mass of a fluid at rest is known only"
            << exit(FatalError);
    }
}


static vibrations::result find(vibrations& all, const label n, const scalar s, const bool wet)
{
    vibrations::result r = all.find(n, s, wet);
    if (!r.failure.empty()) FatalErrorInFunction << r.failure.c_str() << exit(FatalError);
    return r;
}


//- The modes as fields of the solids
static void write(const coupledSystem& system, const List<scalarField>& modes)
{
    forAll(modes, k)
    {
        scalarField x(modes[k].size());
        forAll(x, u) x[u] = modes[k][system.map().global(u)];
        system.constraints().distribute(x);
        for (const feRegion& region : system.regions())
        {
            if (!region.leads()) continue;
            vectorField D(region.fe().nNodes());
            forAll(D, n) D[n] = region.unknowns().at(0, n, x);
            pointVectorField mode
            (
                IOobject("mode" + Foam::name(k + 1), region.mesh().time().timeName(), region.mesh()),
                pointMesh::New(region.mesh()), dimensionedVector(dimLength, Zero)
            );
            region.fe().toPoints<vector>(vectorField(D/max(max(mag(D)), VSMALL)), mode.primitiveFieldRef());
            mode.write();
        }
    }
}


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::noParallel();
    argList::addNote("Frequencies and modes of the solids of a case about its state");
    argList::addOption("n", "N", "Number of frequencies (6)");
    argList::addOption("shift", "f", "Frequency next to which they are, Hz (0)");
    refuseBlanks(argc, argv);
    argList args(argc, argv);
    exitOnError();
    Time runTime(Time::controlDictName, args);
    const label n = args.lookupOrDefault<label>("n", 6);
    const scalar shift = args.lookupOrDefault<scalar>("shift", 0);
    if (n < 1 || shift < 0)
    {
        FatalErrorInFunction
            << "Found -n " << n << " -shift " << shift
            << ", expected a number of 1 or more and a frequency that is not negative" << exit(FatalError);
    }

    coupledSystem system(runTime);
    vibrations all(system);
    vibrations::result dry = find(all, n, constant::mathematical::twoPi*shift, false), wet;
    if (all.hasFluids())
    {
        checkFluids(system);
        wet = find(all, n, shift > 0 ? constant::mathematical::twoPi*shift : dry.omega[0], true);
    }

    const fileName dir(runTime.globalPath()/"postProcessing"/"eigenfrequencies"/runTime.timeName());
    mkDir(dir);
    OFstream os(dir/"frequencies.dat");
    os.precision(12);
    os  << "# Time";
    forAll(dry.omega, k) os << " f" << k + 1;
    forAll(wet.omega, k) os << " w" << k + 1;
    os  << nl << runTime.timeName();
    Info<< "Frequencies (Hz)" << nl;
    forAll(dry.omega, k)
    {
        os  << ' ' << dry.omega[k]/constant::mathematical::twoPi;
        Info<< "    " << k + 1 << ": " << dry.omega[k]/constant::mathematical::twoPi;
        if (k < wet.omega.size()) Info<< ", with the fluids " << wet.omega[k]/constant::mathematical::twoPi;
        Info<< nl;
    }
    for (const scalar omega : wet.omega) os << ' ' << omega/constant::mathematical::twoPi;
    os  << endl;
    write(system, wet.modes.size() ? wet.modes : dry.modes);
    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
