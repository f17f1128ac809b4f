/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

template<class Type>
void Foam::feRegion::toCells
(
    const Field<Type>& nodal,
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const auto centreValue = [&](const auto& E, const elementBlock& block, const auto& put)
    {
        typedef typename std::decay<decltype(E)>::type element;
        double centre[element::dim] = {};
        for (int i = 0; i < E.nVertices; ++i)
        {
            for (int a = 0; a < element::dim; ++a) centre[a] += E.xi[i][a]/E.nVertices;
        }
        double N[element::nNodes], dN[element::nNodes][element::dim];
        element::shape(centre, N, dN);
        for (label e = 0; e < block.size(); ++e)
        {
            Type value = Zero;
            for (int i = 0; i < E.nNodes; ++i) value += N[i]*nodal[block.element(e)[i]];
            put(block.cells[e], value);
        }
    };

    Field<Type>& cells = field.primitiveFieldRef();
    for (const elementBlock& block : fe().blocks())
    {
        withElement(block, [&](auto E)
        {
            centreValue(E, block, [&](const label c, const Type& v) { cells[c] = v; });
        });
    }
    forAll(field.boundaryFieldRef(), patchi)
    {
        auto& pf = field.boundaryFieldRef()[patchi];
        if (pf.coupled()) continue;
        for (const elementBlock& block : fe().patchBlocks(patchi))
        {
            withFaceElement(block, [&](auto E)
            {
                centreValue(E, block, [&](const label f, const Type& v) { pf[f] = v; });
            });
        }
    }
    field.correctBoundaryConditions();
}


template<class Type>
Foam::autoPtr<Foam::GeometricField<Type, Foam::pointPatchField, Foam::pointMesh>>
Foam::feRegion::readPointField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions
)
{
    typedef GeometricField<Type, pointPatchField, pointMesh> fieldType;
    autoPtr<fieldType> field
    (
        new fieldType
        (
            IOobject
            (
                name, mesh.time().timeName(), mesh,
                IOobject::MUST_READ, IOobject::AUTO_WRITE
            ),
            pointMesh::New(mesh)
        )
    );
    if (field->dimensions() != dimensions)
    {
        FatalErrorInFunction
            << "File " << field->objectPath() << " has dimensions "
            << field->dimensions() << ", expected " << dimensions
            << " (SI; pressure in Pa, not divided by the density)"
            << exit(FatalError);
    }
    const auto check = [&](const Field<Type>& values, const word& patch)
    {
        for (const Type& v : values) for (direction c = 0; c < pTraits<Type>::nComponents; ++c)
        {
            if (std::isfinite(component(v, c))) continue;
            FatalErrorInFunction
                << "File " << field->objectPath() << " holds the value " << v
                << (patch.empty() ? "" : " on patch ") << patch
                << ", expected finite numbers" << exit(FatalError);
        }
    };
    check(field->primitiveField(), "");
    for (const auto& pf : field->boundaryField())
    {
        if (!isA<valuePointPatchField<Type>>(pf)) continue;
        check(refCast<const valuePointPatchField<Type>>(pf), pf.patch().name());
    }
    return field;
}
