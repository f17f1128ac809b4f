/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readTurbulence.H"
#include "flowConstants.H"
#include "Enum.H"
#include "IOdictionary.H"
#include "readNumber.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const Enum<eddyModel> eddyModelNames
({
    {eddyModel::SMAGORINSKY, "Smagorinsky"},
    {eddyModel::WALE, "WALE"},
});


static scalar constant
(
    const dictionary& dict,
    const word& name,
    const scalar byDefault
)
{
    return dict.found(name) ? readNumber(dict, name, dimless, 0, GREAT) : byDefault;
}


static scalar eddyConstant(const dictionary& les, const eddyModel model)
{
    const word coeffsName(eddyModelNames[model] + "Coeffs");
    const dictionary coeffs(subDictOrEmpty(les, coeffsName));
    if (model == eddyModel::WALE)
    {
        reportUnknownEntries(coeffs, {"Cw"});
        return constant(coeffs, "Cw", 0.325);
    }
    reportUnknownEntries(coeffs, {"Cs", "Ck", "Ce"});
    if (!coeffs.found("Ck") && !coeffs.found("Ce")) return constant(coeffs, "Cs", 0.1);
    if (coeffs.found("Cs"))
    {
        FatalIOErrorInFunction(coeffs)
            << "Found Cs and Ck or Ce, expected one or the other" << exit(FatalIOError);
    }
    const scalar Ck = constant(coeffs, "Ck", 0.094), Ce = constant(coeffs, "Ce", 1.048);
    return ::sqrt(Ck*::sqrt(Ck/Ce));
}


//- The width of the filter is damped at walls, or that of the elements
static bool isDamped(const dictionary& les)
{
    const auto read = [](const dictionary& dict, const wordList& valid)
    {
        const word delta(dict.lookupOrDefault<word>("delta", "cubeRootVol"));
        if (!valid.found(delta))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown delta " << delta << ". Valid: " << valid << exit(FatalIOError);
        }
        return delta;
    };
    if (read(les, {"cubeRootVol", "vanDriest"}) == "cubeRootVol") return false;
    read(subDictOrEmpty(les, "vanDriestCoeffs"), {"cubeRootVol"});
    return true;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::vanDriestWidth> Foam::readTurbulence(const fvMesh& mesh, flowParameters& k)
{
    const IOdictionary dict
    (
        IOobject
        (
            "turbulenceProperties", mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (dict.empty()) return nullptr;
    reportUnknownEntries(dict, {"simulationType", "LES", "RAS", "laminar"});
    const word type(dict.get<word>("simulationType"));
    if (type == "laminar") return nullptr;
    if (type != "LES")
    {
        FatalIOErrorInFunction(dict)
            << (type == "RAS" ? "There are no RAS models: simulationType " : "Unknown simulationType ")
            << type << ". Valid: (laminar LES), with LESModel " << eddyModelNames.sortedToc()
            << exit(FatalIOError);
    }

    const dictionary& les = dict.subDict("LES");
    const eddyModel model = eddyModelNames.get("LESModel", les);
    reportUnknownEntries
    (
        les,
        {
            "LESModel", "turbulence", "printCoeffs", "delta", "cubeRootVolCoeffs", "vanDriestCoeffs", "kappa",
            word(eddyModelNames[model] + "Coeffs")
        }
    );
    const bool damped = isDamped(les);
    if (!les.lookupOrDefault<Switch>("turbulence", true)) return nullptr;
    const dictionary deltaCoeffs
    (
        subDictOrEmpty(damped ? subDictOrEmpty(les, "vanDriestCoeffs") : les, "cubeRootVolCoeffs")
    );
    reportUnknownEntries(deltaCoeffs, {"deltaCoeff"});

    k.eddy = model;
    k.eddyConstant = eddyConstant(les, model)*constant(deltaCoeffs, "deltaCoeff", 1);
    Info<< "Region " << mesh.name() << ": LES with " << eddyModelNames[model]
        << ", constant " << k.eddyConstant << (damped ? ", filter damped at walls" : "") << nl;
    k.damped = damped;
    return autoPtr<vanDriestWidth>(damped ? new vanDriestWidth(mesh, les) : nullptr);
}


// ************************************************************************* //
