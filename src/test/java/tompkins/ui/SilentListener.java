package tompkins.ui;

import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelReading;

/** Nobody who listens to a photograph. */
public class SilentListener implements PhotographView.Listener {

    @Override
    public void shown(Picture picture) {}

    @Override
    public void read(PixelReading reading, boolean rests) {}

    @Override
    public void pinned(PixelReading reading, String picture) {}

    @Override
    public void noPicture(String message) {}

    @Override
    public void failed(String message) {}

    @Override
    public void hints(String click) {}
}
