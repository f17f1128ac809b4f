/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointHistory.H"
#include "pointFields.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pointHistory, 0);
    addToRunTimeSelectionTable(functionObject, pointHistory, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::functionObjects::pointHistory::findPoint() const
{
    const feMesh& fe = region().fe();

    label nearest = -1;
    scalar nearestSqr = sqr(GREAT);
    forAll(fe.pointNode(), p)
    {
        const label n = fe.pointNode()[p];
        if (n < 0) continue;
        vector d = fe.points()[n] - location_;
        if (fe.dim() == 2) d[fe.axis(2)] = 0;
        if (magSqr(d) < nearestSqr)
        {
            nearest = p;
            nearestSqr = magSqr(d);
        }
    }

    // The lowest of the ranks that have it
    const scalar minSqr = returnReduce(nearestSqr, minOp<scalar>());
    const label rank = returnReduce
    (
        nearestSqr <= minSqr ? Pstream::myProcNo() : labelMax,
        minOp<label>()
    );

    const scalar distance = Foam::sqrt(minSqr);
    if (!begun_ && distance > 1e-6*mag(mesh_.bounds().span()))
    {
        IOWarningInFunction(dict_)
            << "The nearest point of region " << mesh_.name() << " is "
            << distance << " m from the location " << location_ << nl << endl;
    }
    return rank == Pstream::myProcNo() ? nearest : -1;
}


template<class Type>
bool Foam::functionObjects::pointHistory::sample(const label pointi)
{
    typedef GeometricField<Type, pointPatchField, pointMesh> fieldType;

    const fieldType* f = mesh_.cfindObject<fieldType>(field_);
    if (!f) return false;

    Type v = pointi < 0 ? Type(Zero) : (*f)[pointi];
    reduce(v, sumOp<Type>());
    setResult("value", v);

    value_.setSize(pTraits<Type>::nComponents);
    forAll(value_, a) value_[a] = component(v, a);
    return true;
}


void Foam::functionObjects::pointHistory::writeFileHeader()
{
    if (begun_) return;
    begun_ = true;

    writeHeader(file(), field_ + " at the point next to the location");
    writeHeaderValue(file(), "location", location_);
    if (value_.size() == 1) writeColumns(file(), {"value"});
    else
    {
        word stem(field_);
        stem.replace("point", "");
        writeColumns(file(), {word(stem + 'x'), word(stem + 'y'), word(stem + 'z')});
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pointHistory::pointHistory
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, typeName),
    begun_(false)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pointHistory::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    dict.readEntry("field", field_);
    dict.readEntry("location", location_);

    return true;
}


bool Foam::functionObjects::pointHistory::execute()
{
    const label pointi = findPoint();
    if (sample<vector>(pointi) || sample<scalar>(pointi)) return true;

    wordList names(mesh_.sortedNames<pointVectorField>());
    names.append(mesh_.sortedNames<pointScalarField>());
    FatalIOErrorInFunction(dict_)
        << "Region " << mesh_.name() << " has no point field '" << field_
        << "' of scalars or vectors. There are " << names << exit(FatalIOError);
    return false;
}


bool Foam::functionObjects::pointHistory::write()
{
    writeFileHeader();

    Log << type() << " " << name() << " write:" << nl
        << "    " << field_ << " =";
    for (const scalar v : value_) Log << ' ' << v;
    Log << nl << endl;

    writeRow(file(), value_);
    return true;
}


// ************************************************************************* //
