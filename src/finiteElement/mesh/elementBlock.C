/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementBlock.H"
#include "DynamicList.H"
#include <cstdint>
#include <vector>

const char* Foam::elementName(const elementShape shape)
{
    static const char* names[] =
        {"line", "tri", "quad", "tet", "hex", "prism", "pyramid"};
    return names[int(shape)];
}


Foam::label Foam::elementBlock::nVertices() const
{
    label n = 2;
    withElement(*this, [&](auto E) { n = E.nVertices; });
    return n;
}


void Foam::elementBlock::colour
(
    const label nMeshNodes,
    const UList<labelList>& further,
    const label nFurther
)
{
    // Some hundred chunks are enough for all threads and colours
    chunkSize = max(label(1), min(label(16), nBatches()/64));
    const label nChunks = (nBatches() + chunkSize - 1)/chunkSize;

    // Bit c of a node: a chunk of colour c has it
    std::vector<std::uint64_t> used(nMeshNodes + nFurther, 0);
    DynamicList<DynamicList<label>> chunks;

    const auto forNodes = [&](const label chunk, const auto& f)
    {
        forBatches(chunk, [&](const label batch)
        {
            for (int l = 0; l < nLanes(batch); ++l)
            {
                const label* nodes = element(lane(batch, l));
                for (label i = 0; i < nNodes; ++i) f(used[nodes[i]]);
                if (further.empty()) continue;
                for (const label k : further[lane(batch, l)]) f(used[nMeshNodes + k]);
            }
        });
    };
    for (label chunk = 0; chunk < nChunks; ++chunk)
    {
        std::uint64_t taken = 0;
        forNodes(chunk, [&](std::uint64_t& u) { taken |= u; });
        label c = 0;
        while (c < 63 && (taken >> c & 1)) ++c;

        forNodes(chunk, [&](std::uint64_t& u) { u |= std::uint64_t(1) << c; });
        if (c >= chunks.size()) chunks.setSize(c + 1);
        chunks[c].append(chunk);
    }

    // More than 63 colours: the chunks of the last are done one by one
    colours.clear();
    forAll(chunks, c)
    {
        if (c < 63) colours.append(labelList(chunks[c]));
        else for (const label k : chunks[c]) colours.append(labelList(1, k));
    }
}
