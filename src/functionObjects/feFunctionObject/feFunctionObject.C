/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feFunctionObject.H"
#include "Time.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::tableFile::reportUnknownEntries
(
    const dictionary& dict,
    const wordList& own
)
{
    wordList all
    ({
        "type", "libs", "functionObjectLibs", "enabled", "errors", "log",
        "region", "subRegion", "controlMode", "timeStart", "timeEnd",
        "triggerStart", "triggerEnd", "deltaTCoeff", "nStepsToStartTimeChange",
        "executeControl", "executeInterval", "writeControl", "writeInterval",
        "outputControl", "outputInterval", "writePrecision", "writeToFile",
        "useUserTime"
    });
    all.append(own);
    Foam::reportUnknownEntries(dict, all);
}


void Foam::functionObjects::tableFile::writeColumns
(
    Ostream& os,
    const wordList& names
) const
{
    writeCommented(os, "Time");
    for (const word& name : names) writeTabbed(os, name);
    os  << endl;
}


void Foam::functionObjects::tableFile::writeRow
(
    Ostream& os,
    const scalarList& values
) const
{
    writeCurrentTime(os);
    for (const scalar v : values) os << tab << setw(charWidth()) << v;
    os  << endl;
}


const Foam::objectRegistry& Foam::functionObjects::feFunctionObject::findRegion
(
    const Time& runTime,
    const dictionary& dict
)
{
    const word name(dict.lookupOrDefault<word>("region", polyMesh::defaultRegion));
    const fvMesh* mesh = runTime.cfindObject<fvMesh>(name);
    if (!mesh)
    {
        FatalIOErrorInFunction(dict)
            << "There is no region '" << name << "'. The regions are "
            << runTime.sortedNames<fvMesh>() << exit(FatalIOError);
    }
    return *mesh;
}


const Foam::feRegion& Foam::functionObjects::feFunctionObject::region() const
{
    const feRegion* r = mesh_.cfindObject<feRegion>("feRegion");
    if (!r)
    {
        FatalIOErrorInFunction(dict_)
            << "Region '" << mesh_.name() << "' has no solver of"
            << " monolithicFoam, which function objects of type " << type()
            << " need. regionSolvers in controlDict names the regions that do."
            << exit(FatalIOError);
    }
    return *r;
}


template<class Type>
const Foam::Field<Type>* Foam::functionObjects::feFunctionObject::nodal
(
    const word& pointField
) const
{
    static const HashTable<word> names
    ({
        {"pointU", "U"}, {"pointD", "D"}, {"pointDisplacement", "meshDisplacement"}
    });

    const auto name = names.cfind(pointField);
    if (!name.found()) return nullptr;
    return region().state().find<Type>(*name);
}

template const Foam::Field<Foam::scalar>*
Foam::functionObjects::feFunctionObject::nodal(const word&) const;

template const Foam::Field<Foam::vector>*
Foam::functionObjects::feFunctionObject::nodal(const word&) const;


Foam::tmp<Foam::vectorField>
Foam::functionObjects::feFunctionObject::positions() const
{
    const feMesh& fe = region().fe();

    // Displacement of the points, of which higher nodes take the mean
    vectorField d(mesh_.nPoints(), Zero);
    forAll(d, p)
    {
        const label n = fe.pointNode()[p];
        if (n < 0) continue;
        d[p] = mesh_.points()[p] - fe.points()[n];
        if (fe.dim() == 2) d[p][fe.axis(2)] = 0;
    }
    tmp<vectorField> tx(fe.interpolate(d));
    tx.ref() += fe.points();
    return tx;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::tableFile::tableFile
(
    const objectRegistry& obr,
    const word& prefix,
    const dictionary& dict
)
:
    writeFile(obr, prefix, prefix)
{
    tableFile::read(dict);
}


Foam::functionObjects::tableFile::tableFile
(
    const objectRegistry& obr,
    const word& prefix,
    const word& file,
    const dictionary& dict
)
:
    tableFile(obr, prefix, dict)
{
    if (writeToFile_) resetFile(file);
}


Foam::functionObjects::feFunctionObject::feFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& file
)
:
    fvMeshFunctionObject(name, findRegion(runTime, dict), dict),
    tableFile(mesh_, name, file, dict),
    dict_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::tableFile::read(const dictionary& dict)
{
    writeFile::read(dict);
    if (!dict.found("writePrecision")) writePrecision_ = max(writePrecision_, 9);
    return true;
}


bool Foam::functionObjects::feFunctionObject::read(const dictionary& dict)
{
    dict_ = dict;
    return fvMeshFunctionObject::read(dict) && tableFile::read(dict);
}


// ************************************************************************* //
