package tompkins.ui;

import java.awt.Point;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import tompkins.camera.FocusDistance;
import tompkins.measure.RayTubes;
import tompkins.property.NumberText;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.SampleHistory;
import tompkins.ui.editor.ChooseTool;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.TabStrip;
import tompkins.ui.widget.Texts;

/** What can be done with what is seen at a place of the picture. */
final class PictureMenu implements PhotographView.Menu {

    private final TompkinsWindow window;

    PictureMenu(TompkinsWindow window) {
        this.window = window;
    }

    @Override
    public void show(PixelReading seen, Picture picture, Point2D place, Point at) {
        JPopupMenu menu = new JPopupMenu();
        add(menu, "lookAt", true, () -> window.motion.lookAt(place));
        double depth = seen.depth(picture.studio().camera());
        add(menu, "focus", depth > 0, () -> focus(depth));
        add(menu, "rideFrom", seen.sighting().hit() != null, () -> window.motion.rideFrom(seen.sighting()));
        add(menu, "measureFrom", true, () -> {
            window.strip.open(TabStrip.Tab.MEASURE);
            window.measure.begin(place, picture);
        });
        List<SampleHistory> ray = Stream.ofNullable(seen.sighting().life()).toList();
        add(menu, "drawRay", RayTubes.canDraw(ray), () -> drawRay(seen, ray));
        Optional<StudioPath> object = ChooseTool.object(window.model(), seen);
        add(menu, "edit", object.isPresent(), () -> object.ifPresent(window.side::edit));
        menu.show(window.view().canvas(), at.x, at.y);
    }

    private void focus(double distance) {
        Studio studio = window.model().studio();
        window.model().set(studio.withCamera(FocusDistance.with(studio.camera(), NumberText.rounded(distance, 6))));
    }

    private void drawRay(PixelReading seen, List<SampleHistory> ray) {
        String name = Texts.get("ray.drawn.ray", Texts.get("probe.pixel", seen.column(), seen.row()));
        window.model().set(RayTubes.addedTo(window.model().studio(), name, ray));
    }

    private static void add(JPopupMenu menu, String key, boolean possible, Runnable action) {
        JMenuItem item = new JMenuItem(Texts.get("picture." + key));
        Naming.name(item, "picture." + key);
        item.setEnabled(possible);
        item.addActionListener(event -> action.run());
        menu.add(item);
    }
}
