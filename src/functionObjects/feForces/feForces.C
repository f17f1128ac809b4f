/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feForces.H"
#include "nonlinearSolid.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feForces, 0);
    addToRunTimeSelectionTable(functionObject, feForces, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::feForces::nodes() const
{
    const feMesh& fe = region().fe();

    labelHashSet found;
    for (const label patchi : patches_) found.insert(fe.patchNodes(patchi));
    return found.sortedToc();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feForces::feForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "forces"),
    CofR_(Zero),
    force_(Zero),
    moment_(Zero)
{
    read(dict);

    writeHeader(file(), "Force (N) and moment (N m), in 2-D per metre of depth");
    writeHeaderValue(file(), "CofR", CofR_);
    writeColumns(file(), {"fx", "fy", "fz", "mx", "my", "mz"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feForces::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    reportUnknownEntries(dict, {"patches", "CofR"});
    patches_ = region().fe().patchIndices(dict.get<wordRes>("patches"), dict);
    CofR_ = dict.lookupOrDefault<point>("CofR", Zero);

    return true;
}


bool Foam::functionObjects::feForces::execute()
{
    const feMesh& fe = region().fe();
    const vectorField x(positions());

    // What supports do is no remainder of the balance
    vectorField R(region().force());
    if (const auto* solid = dynamic_cast<const nonlinearSolid*>(&region())) R += solid->supports(patches_);

    force_ = moment_ = Zero;
    for (const label n : nodes())
    {
        vector r = x[n] - CofR_;
        if (fe.dim() == 2) r[fe.axis(2)] = 0;
        force_ -= R[n];
        moment_ -= r ^ R[n];
    }
    reduce(force_, sumOp<vector>());
    reduce(moment_, sumOp<vector>());

    setResult("forces", force_);
    setResult("moments", moment_);

    return true;
}


bool Foam::functionObjects::feForces::write()
{
    const vector &f = force_, &m = moment_;

    Log << type() << " " << name() << " write:" << nl
        << "    Sum of forces" << nl
        << "        Total    : " << f << nl
        << "    Sum of moments" << nl
        << "        Total    : " << m << nl << endl;

    writeRow(file(), {f.x(), f.y(), f.z(), m.x(), m.y(), m.z()});
    return true;
}


// ************************************************************************* //
