/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feSolidEnergy.H"
#include "solidRegion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feSolidEnergy, 0);
    addToRunTimeSelectionTable(functionObject, feSolidEnergy, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar storedEnergy(const solidIntegrals& s) { return s.kinetic + s.strain + s.weight; }

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::nonlinearSolid& Foam::functionObjects::feSolidEnergy::solid() const
{
    return solidRegion(region(), dict_);
}


void Foam::functionObjects::feSolidEnergy::addWork()
{
    FixedList<vectorField, nWorks> forces;
    forces[VISCOUS] = solid().viscousForces();
    forces[LOADS] = solid().loads();
    forces[REACTIONS] = solid().force();
    scalarField P(nWorks);
    forAll(P, k) P[k] = gSum(powers_[k](solid(), forces[k]));
    integral_.add(solid().timeScheme(), P);
    integral_.keep(propertyDict());
    setProperty("start", start_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feSolidEnergy::feSolidEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "solidEnergy"),
    start_(0)
{
    read(dict);
    const solidIntegrals now(solid().integrals());
    start_ = getProperty<scalar>("start", storedEnergy(now));
    integral_.begin(propertyDict(), nWorks);

    writeHeader(file(), "Energies and work (J), momentum (N s) and its moment (N m s), in 2-D per metre of depth");
    writeHeaderValue(file(), "Mass", now.mass);
    writeColumns
    (
        file(),
        {
            "kinetic", "strain", "weight", "viscous", "loads", "reactions", "balance",
            "px", "py", "pz", "hx", "hy", "hz"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feSolidEnergy::read(const dictionary& dict)
{
    feFunctionObject::read(dict);
    reportUnknownEntries(dict, {});
    solid();
    return true;
}


bool Foam::functionObjects::feSolidEnergy::execute()
{
    addWork();
    const solidIntegrals s(solid().integrals());
    const scalarField& work = integral_.works();
    const scalar balance = storedEnergy(s) - start_ + work[VISCOUS] - work[LOADS] - work[REACTIONS];
    const vector &p = s.momentum, &h = s.angularMomentum;
    row_ =
    {
        s.kinetic, s.strain, s.weight, work[VISCOUS], work[LOADS], work[REACTIONS], balance,
        p.x(), p.y(), p.z(), h.x(), h.y(), h.z()
    };
    setResult("kinetic", s.kinetic);
    setResult("strain", s.strain);
    setResult("balance", balance);
    return true;
}


bool Foam::functionObjects::feSolidEnergy::write()
{
    Log << type() << " " << name() << " write:" << nl
        << "    Kinetic " << row_[0] << ", strain " << row_[1] << ", balance " << row_[6] << nl << endl;
    writeRow(file(), row_);
    return true;
}


// ************************************************************************* //
