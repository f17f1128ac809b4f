/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceBalance.H"
#include "OFstream.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(interfaceBalance, 0);
    addToRunTimeSelectionTable(functionObject, interfaceBalance, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::interfaceReport&
Foam::functionObjects::interfaceBalance::report() const
{
    const interfaceReport* r =
        time().cfindObject<interfaceReport>(interfaceReport::typeName);
    if (!r || !r->nInterfaces())
    {
        FatalIOErrorInFunction(dict_)
            << "There is no fluid-structure interface to report on. Function"
            << " object " << name() << " needs monolithicFoam with interfaces"
            << " in constant/couplingProperties." << exit(FatalIOError);
    }
    return *r;
}


void Foam::functionObjects::interfaceBalance::open(const interfaceReport& r)
{
    files_.setSize(r.nInterfaces());
    forAll(files_, i)
    {
        const word name = r.interfaceName(i);
        files_.set
        (
            i,
            createFile
            (
                files_.size() == 1 ? word(typeName) : word(typeName + '_' + name)
            )
        );
        writeHeader(files_[i], "Force (N) and power (W) on both sides, distance (m) and flux (m3/s) between them, in 2-D"
            " per metre of depth");
        writeHeaderValue(files_[i], "interface", name);
        writeColumns
        (
            files_[i],
            {
                "fluidFx", "fluidFy", "fluidFz", "solidFx", "solidFy", "solidFz",
                "fluidPower", "solidPower", "forceImbalance", "powerImbalance", "distance", "leakage"
            }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::interfaceBalance::interfaceBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    stateFunctionObject(name, runTime),
    tableFile(runTime, name, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::interfaceBalance::read(const dictionary& dict)
{
    dict_ = dict;
    reportUnknownEntries(dict, {});
    return stateFunctionObject::read(dict) && tableFile::read(dict);
}


bool Foam::functionObjects::interfaceBalance::write()
{
    const interfaceReport& r = report();
    if (writeToFile() && files_.size() != r.nInterfaces()) open(r);

    Log << type() << " " << name() << " write:" << nl;
    for (label i = 0; i < r.nInterfaces(); ++i)
    {
        const vector Ff = r.fluidForce(i), Fs = r.solidForce(i);
        const scalar Pf = r.fluidPower(i), Ps = r.solidPower(i);
        const scalar force = mag(Ff + Fs)/max(max(mag(Ff), mag(Fs)), VSMALL);
        const scalar power = mag(Pf + Ps)/max(max(mag(Pf), mag(Ps)), VSMALL);
        const interfaceGap gap = r.gap(i);

        Log << "    " << r.interfaceName(i) << ": force on fluid " << Ff
            << ", imbalance " << force << "; power " << Pf
            << ", imbalance " << power << "; distance " << gap.distance << ", leakage " << gap.leakage << nl;
        if (!writeToFile()) continue;
        writeRow
        (
            files_[i],
            {
                Ff.x(), Ff.y(), Ff.z(), Fs.x(), Fs.y(), Fs.z(),
                Pf, Ps, force, power, gap.distance, gap.leakage
            }
        );
    }
    Log << endl;

    return true;
}


// ************************************************************************* //
