/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feSolidFields.H"
#include "solidRegion.H"
#include "addToRunTimeSelectionTable.H"
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feSolidFields, 0);
    addToRunTimeSelectionTable(functionObject, feSolidFields, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class Type>
struct solidField
{
    const char* name;
    dimensionSet dimensions;
    Type (solidPoint::*of)() const;
};

//- The fields of a type. Not a List, which assigns: that is not for dimensions
template<class Type>
static std::vector<solidField<Type>> solidFields();

template<>
std::vector<solidField<scalar>> solidFields()
{
    return {{"J", dimless, &solidPoint::J}, {"energyDensity", dimPressure, &solidPoint::energyDensity}};
}

template<>
std::vector<solidField<vector>> solidFields()
{
    return
    {
        {"principalStress", dimPressure, &solidPoint::principalStress},
        {"principalStretch", dimless, &solidPoint::principalStretch}
    };
}

template<>
std::vector<solidField<symmTensor>> solidFields()
{
    return
    {
        {"sigma", dimPressure, &solidPoint::sigma},
        {"secondPiola", dimPressure, &solidPoint::secondPiola},
        {"GreenStrain", dimless, &solidPoint::GreenStrain},
        {"logStrain", dimless, &solidPoint::logStrain}
    };
}

template<>
std::vector<solidField<tensor>> solidFields()
{
    return
    {
        {"firstPiola", dimPressure, &solidPoint::firstPiola},
        {"principalDirections", dimless, &solidPoint::principalDirections}
    };
}

template<class Type>
static void addNames(wordList& names)
{
    for (const auto& f : solidFields<Type>()) names.append(f.name);
}

//- Means of directions say nothing
static bool hasPoints(const word& name) { return name != "principalDirections"; }

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::nonlinearSolid& Foam::functionObjects::feSolidFields::solid() const
{
    const feRegion* region = mesh_.cfindObject<feRegion>("feRegion");
    if (!region)
    {
        FatalIOErrorInFunction(dict_)
            << "Region '" << mesh_.name() << "' has no solver of monolithicFoam, which function"
            << " objects of type " << type() << " need" << exit(FatalIOError);
    }
    return solidRegion(*region, dict_);
}


template<class FieldType>
FieldType& Foam::functionObjects::feSolidFields::field
(
    const word& name,
    const dimensionSet& dimensions,
    const typename FieldType::Mesh& mesh,
    const word& patchType
)
{
    typedef typename FieldType::value_type Type;
    if (!made_.found(name))
    {
        made_.set
        (
            name,
            new FieldType
            (
                IOobject(name, mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE),
                mesh, dimensioned<Type>(dimensions, Zero), patchType
            )
        );
    }
    return refCast<FieldType>(*made_[name]);
}


template<class Type>
void Foam::functionObjects::feSolidFields::compute()
{
    typedef GeometricField<Type, fvPatchField, volMesh> cellField;
    typedef GeometricField<Type, pointPatchField, pointMesh> pointField;
    for (const solidField<Type>& f : solidFields<Type>())
    {
        const word name(f.name);
        if (!fields_.found(name)) continue;
        if (name != "sigma")
        {
            auto& cells = field<cellField>(name, f.dimensions, mesh_, "zeroGradient");
            cells.primitiveFieldRef() = solid().cellValues<Type>(f.of);
            cells.correctBoundaryConditions();
        }
        if (!points_ || !hasPoints(name)) continue;
        word pointName(name);
        pointName[0] = ::toupper(pointName[0]);
        auto& points = field<pointField>
        (
            "point" + pointName, f.dimensions, pointMesh::New(mesh_), "calculated"
        );
        points.primitiveFieldRef() = solid().pointValues<Type>(f.of);
    }
}


void Foam::functionObjects::feSolidFields::computeAll()
{
    compute<scalar>();
    compute<vector>();
    compute<symmTensor>();
    compute<tensor>();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feSolidFields::feSolidFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feSolidFields::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    dict_ = dict;
    tableFile::reportUnknownEntries(dict, {"fields", "points"});
    solid();

    wordList names;
    addNames<scalar>(names);
    addNames<vector>(names);
    addNames<symmTensor>(names);
    addNames<tensor>(names);
    fields_ = dict.get<wordList>("fields");
    points_ = dict.lookupOrDefault("points", true);
    for (const word& name : fields_)
    {
        if (names.found(name)) continue;
        FatalIOErrorInFunction(dict)
            << "There is no field " << name << " of a solid. The fields are " << names
            << exit(FatalIOError);
    }
    return true;
}


bool Foam::functionObjects::feSolidFields::execute()
{
    if (dict_.found("executeControl")) computeAll();
    return true;
}


bool Foam::functionObjects::feSolidFields::write()
{
    computeAll();
    forAllConstIters(made_, iter) (*iter)->write();
    return true;
}


// ************************************************************************* //
