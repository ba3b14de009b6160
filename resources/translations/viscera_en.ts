<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>viscera::app::ArchiveDialog</name>
    <message numerus="yes">
        <source>%n studies. Open one to see its series.</source>
        <translation>
            <numerusform>%n study. Open it to see its series.</numerusform>
            <numerusform>%n studies. Open one to see its series.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::BindingMessages</name>
    <message numerus="yes">
        <source>%n vertices of %1 have no coordinates in the cage.</source>
        <translation>
            <numerusform>%n vertex of %1 has no coordinates in the cage.</numerusform>
            <numerusform>%n vertices of %1 have no coordinates in the cage.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie in no group&apos;s region.</source>
        <translation>
            <numerusform>%n vertex of %1 lies in no group&apos;s region.</numerusform>
            <numerusform>%n vertices of %1 lie in no group&apos;s region.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles&apos; hull.</source>
        <translation>
            <numerusform>%n vertex of %1 lies outside the handles&apos; hull.</numerusform>
            <numerusform>%n vertices of %1 lie outside the handles&apos; hull.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</source>
        <translation>
            <numerusform>%n vertex of %1 lies outside the handles of the motion, so %1 stays at rest.</numerusform>
            <numerusform>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CinePage</name>
    <message numerus="yes">
        <source>%1: %2 phases, %n planes</source>
        <translation>
            <numerusform>%1: %2 phases, %n plane</numerusform>
            <numerusform>%1: %2 phases, %n planes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourCorrector</name>
    <message numerus="yes">
        <source>The motion is that of the images again. %n phases have changed.</source>
        <translation>
            <numerusform>The motion is that of the images again. %n phase has changed.</numerusform>
            <numerusform>The motion is that of the images again. %n phases have changed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases have changed.</source>
        <translation>
            <numerusform>%n phase has changed.</numerusform>
            <numerusform>%n phases have changed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformPage</name>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n handle</numerusform>
            <numerusform>%n handles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ExplorePage</name>
    <message numerus="yes">
        <source>open, %n edges</source>
        <translation>
            <numerusform>open, %n edge</numerusform>
            <numerusform>open, %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases</source>
        <translation>
            <numerusform>%n phase</numerusform>
            <numerusform>%n phases</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases in %1 s</source>
        <translation>
            <numerusform>%n phase in %1 s</numerusform>
            <numerusform>%n phases in %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ExportActions</name>
    <message numerus="yes">
        <source>The rest position of %n points of the field is uncertain.</source>
        <translation>
            <numerusform>The rest position of %n point of the field is uncertain.</numerusform>
            <numerusform>The rest position of %n points of the field is uncertain.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::FileActions</name>
    <message numerus="yes">
        <source>Opening %n files</source>
        <translation>
            <numerusform>Opening %n file</numerusform>
            <numerusform>Opening %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The %n vertices of %1 are now the handles.</source>
        <translation>
            <numerusform>The %n vertex of %1 are now the handles.</numerusform>
            <numerusform>The %n vertices of %1 are now the handles.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more findings; see the organs&apos; pages in Explore mode</source>
        <translation>
            <numerusform>%n more finding; see the organ&apos;s page in Explore mode</numerusform>
            <numerusform>%n more findings; see the organs&apos; pages in Explore mode</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::FitBox</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::GroupPanel</name>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to the group.</source>
        <translation>
            <numerusform>Automatic grouping has added %n corner handle to the group.</numerusform>
            <numerusform>Automatic grouping has added %n corner handles to the group.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to %1 of %2 groups.</source>
        <translation>
            <numerusform>Automatic grouping has added %n corner handle to %1 of %2 groups.</numerusform>
            <numerusform>Automatic grouping has added %n corner handles to %1 of %2 groups.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::GuideWindow</name>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleController</name>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>Move %n handle</numerusform>
            <numerusform>Move %n handles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n handles</source>
        <translation>
            <numerusform>Turn %n handle</numerusform>
            <numerusform>Turn %n handles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n handles</source>
        <translation>
            <numerusform>Scale %n handle</numerusform>
            <numerusform>Scale %n handles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesMode</name>
    <message numerus="yes">
        <source>%n handles removed</source>
        <translation>
            <numerusform>%n handle removed</numerusform>
            <numerusform>%n handles removed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesPage</name>
    <message numerus="yes">
        <source>%1 ms, %n threads</source>
        <translation>
            <numerusform>%1 ms, %n thread</numerusform>
            <numerusform>%1 ms, %n threads</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportController</name>
    <message numerus="yes">
        <source>Check of %n files</source>
        <translation>
            <numerusform>Check of %n file</numerusform>
            <numerusform>Check of %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportPanel</name>
    <message numerus="yes">
        <source>Import %n organs</source>
        <translation>
            <numerusform>Import %n organ</numerusform>
            <numerusform>Import %n organs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasuredMotion</name>
    <message numerus="yes">
        <source>Motion of %n phases. Mean distance from the measured surfaces: %1.</source>
        <translation>
            <numerusform>Motion of %n phase. Mean distance from the measured surfaces: %1.</numerusform>
            <numerusform>Motion of %n phases. Mean distance from the measured surfaces: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases need attention: see the table beside the chart.</source>
        <translation>
            <numerusform>%n phase needs attention: see the table beside the chart.</numerusform>
            <numerusform>%n phases need attention: see the table beside the chart.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>An estimate of %n phase from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</numerusform>
            <numerusform>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Motion of %n phase from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</numerusform>
            <numerusform>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::Menus</name>
    <message numerus="yes">
        <source>%n earlier steps</source>
        <translation>
            <numerusform>%n earlier step</numerusform>
            <numerusform>%n earlier steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::MotionDialog</name>
    <message numerus="yes">
        <source>%1: label maps, %n phases</source>
        <translation>
            <numerusform>%1: label maps, %n phase</numerusform>
            <numerusform>%1: label maps, %n phases</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: surfaces, %n phases</source>
        <translation>
            <numerusform>%1: surfaces, %n phase</numerusform>
            <numerusform>%1: surfaces, %n phases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganCheck</name>
    <message numerus="yes">
        <source>%n checks passed</source>
        <translation>
            <numerusform>%n check passed</numerusform>
            <numerusform>%n checks passed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganPanel</name>
    <message numerus="yes">
        <source>%1
%n triangles</source>
        <translation>
            <numerusform>%1
%n triangle</numerusform>
            <numerusform>%1
%n triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs removed</source>
        <translation>
            <numerusform>%n organ removed</numerusform>
            <numerusform>%n organs removed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs and all handles removed</source>
        <translation>
            <numerusform>%n organ and all handles removed</numerusform>
            <numerusform>%n organs and all handles removed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::PoseEditor</name>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>Move %n handle</numerusform>
            <numerusform>Move %n handles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reset %n handles</source>
        <translation>
            <numerusform>Reset %n handle</numerusform>
            <numerusform>Reset %n handles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is open (%n boundary edges), so it has no volume that could be locked.</source>
        <translation>
            <numerusform>%1 is open (%n boundary edge), so it has no volume that could be locked.</numerusform>
            <numerusform>%1 is open (%n boundary edges), so it has no volume that could be locked.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::QuizTool</name>
    <message numerus="yes">
        <source>All %1 found, with %n mistakes.</source>
        <translation>
            <numerusform>All %1 found, with %n mistake.</numerusform>
            <numerusform>All %1 found, with %n mistakes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ReportExport</name>
    <message numerus="yes">
        <source>%1: %n pages.</source>
        <translation>
            <numerusform>%1: %n page.</numerusform>
            <numerusform>%1: %n pages.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n commands are in the clipboard.</source>
        <translation>
            <numerusform>%n command is in the clipboard.</numerusform>
            <numerusform>%n commands are in the clipboard.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ScanActions</name>
    <message numerus="yes">
        <source>%n more: see Scan on the page of Explore.</source>
        <translation>
            <numerusform>%n more: see Scan on the page of Explore.</numerusform>
            <numerusform>%n more: see Scan on the page of Explore.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, all %n slices, resampled to an even grid</source>
        <translation>
            <numerusform>, all %n slice, resampled to an even grid</numerusform>
            <numerusform>, all %n slices, resampled to an even grid</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>  %n phases</source>
        <translation>
            <numerusform>  %n phase</numerusform>
            <numerusform>  %n phases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionFiles</name>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And %n more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::StatusLine</name>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n handle</numerusform>
            <numerusform>%n handles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs</source>
        <translation>
            <numerusform>%n organ</numerusform>
            <numerusform>%n organs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::StressPage</name>
    <message numerus="yes">
        <source>%n points lie outside the handles&apos; hull and stay where they are.</source>
        <translation>
            <numerusform>%n point lies outside the handles&apos; hull and stay where they are.</numerusform>
            <numerusform>%n points lie outside the handles&apos; hull and stay where they are.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumePanel</name>
    <message numerus="yes">
        <source>%n more organs are not drawn: choose one to see its volume.</source>
        <translation>
            <numerusform>%n more organ is not drawn: choose it to see its volume.</numerusform>
            <numerusform>%n more organs are not drawn: choose one to see its volume.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::WarpExport</name>
    <message numerus="yes">
        <source>The pose folds the tissue at %n voxels: their values are estimates.</source>
        <translation>
            <numerusform>The pose folds the tissue at %n voxel: their values are estimates.</numerusform>
            <numerusform>The pose folds the tissue at %n voxels: their values are estimates.</numerusform>
        </translation>
    </message>
</context>
</TS>
