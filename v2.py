import sys,json
from PIL import Image
import numpy as np
n=sys.argv[1]
out=[]
for v in ('face_front','face_side','body_side'):
    im=Image.open(f'{n}/{v}.jpg').convert('RGB'); lab=Image.open(f'{n}/{v}_labels.png').convert('RGB')
    if v=='body_side':
        t=np.asarray(Image.open(f'{n}/{v}_labels.png')); ys,xs=np.nonzero(t); y=ys.min(); x=int(xs[ys<y+150].mean()); b=(x-130,y-20,x+130,y+240); im=im.crop(b).resize((700,700)); lab=lab.crop(b).resize((700,700))
    else: im=im.resize((700,int(im.size[1]*700/im.size[0]))).crop((0,0,700,700)); lab=lab.resize((700,int(lab.size[1]*700/lab.size[0]))).crop((0,0,700,700))
    out.append(np.vstack([np.asarray(im),np.asarray(lab)]))
Image.fromarray(np.hstack(out)).resize((1400,933)).save('/tmp/z.png')
