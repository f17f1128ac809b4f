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

void Foam::functionObjects::pointHistory::findNode()
{
    if (searched_) return;
    searched_ = true;

    const feMesh& fe = region().fe();
    scalar nearestSqr = sqr(GREAT);
    forAll(fe.points(), n)
    {
        vector d = fe.points()[n] - location_;
        if (fe.dim() == 2) d[fe.axis(2)] = 0;
        if (magSqr(d) < nearestSqr)
        {
            node_ = n;
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
    if (distance > 1e-6*mag(mesh_.bounds().span()))
    {
        IOWarningInFunction(dict_)
            << "The nearest node of region " << mesh_.name() << " is "
            << distance << " m from the location " << location_ << nl << endl;
    }

    if (rank != Pstream::myProcNo())
    {
        node_ = -1;
        return;
    }
    labelList vertices(1, node_);
    if (node_ >= fe.nVertices())
    {
        vertices = fe.parents()[node_];
    }
    points_ = UIndirectList<label>(fe.vertexPoint(), vertices);
}


template<class Type>
Type Foam::functionObjects::pointHistory::valueOf
(
    const GeometricField<Type, pointPatchField, pointMesh>& field
) const
{
    if (node_ < 0) return Zero;

    const Field<Type>* unknowns = points_.size() > 1 ? nodal<Type>(field_) : nullptr;
    return unknowns ? (*unknowns)[node_] : average(Field<Type>(field.primitiveField(), points_));
}


template<class Type>
bool Foam::functionObjects::pointHistory::sample()
{
    typedef GeometricField<Type, pointPatchField, pointMesh> fieldType;

    const fieldType* f = mesh_.cfindObject<fieldType>(field_);
    if (!f) return false;

    const Type v = returnReduce(valueOf(*f), sumOp<Type>());
    setResult("value", v);

    value_.setSize(pTraits<Type>::nComponents);
    forAll(value_, a) value_[a] = component(v, a);
    return true;
}


void Foam::functionObjects::pointHistory::writeFileHeader()
{
    if (begun_) return;
    begun_ = true;

    writeHeader(file(), field_ + " at the node next to the location");
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
    searched_(false),
    begun_(false),
    node_(-1)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pointHistory::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    dict.readEntry("field", field_);
    dict.readEntry("location", location_);
    reportUnknownEntries(dict, {"field", "location"});
    searched_ = false;

    return true;
}


bool Foam::functionObjects::pointHistory::execute()
{
    findNode();
    if (sample<vector>() || sample<scalar>()) return true;

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
